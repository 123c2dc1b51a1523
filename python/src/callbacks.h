// SPDX-License-Identifier: MIT
// Functions of Python as hooks of the library, which calls them from any of its threads.
#pragma once

#include <nanobind/nanobind.h>
#include <nanobind/stl/string.h>

#include <memory>

#include "dermis/hooks.h"
#include "work.h"

namespace dermis::python {

/// A function of Python that any thread may own, with the GIL or without.
class Callback {
 public:
  explicit Callback(const nanobind::object& function);
  Callback(const Callback&) = delete;
  Callback& operator=(const Callback&) = delete;
  ~Callback();
  /// Needs the GIL.
  nanobind::handle function() const { return function_; }

 private:
  PyObject* function_;
};

/// Returns null for None.
std::shared_ptr<Callback> callback_of(const nanobind::object& function);

/// Hooks of a call at the desk. `progress`: called as f(what, share); False ends the work (Cancelled), an
/// exception ends it and reaches the caller; may be null. Lines go to the logger "dermis".
Hooks hooks_of(const std::shared_ptr<Desk>& desk, const std::shared_ptr<Callback>& progress);

}  // namespace dermis::python
