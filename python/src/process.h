// SPDX-License-Identifier: MIT
// A device, its threads and its memory belong to the process that made them. A child that was forked has
// copies of the handles and none of the threads: each entry compares process ids, whoever forked.
#pragma once

#include <memory>
#include <utility>

namespace dermis::python {

/// Remembers the process that the module was imported in.
void remember_process();
bool is_our_process();
/// Throws std::runtime_error (RuntimeError in Python) in a process that was forked.
void check_process();

/// Makes an object that its last owner destroys, but not in a process that was forked: there it stays.
template <class T, class... Args>
std::shared_ptr<T> make_owned(Args&&... args) {
  return std::shared_ptr<T>(new T{std::forward<Args>(args)...}, [](T* object) {
    if (is_our_process()) delete object;
  });
}

}  // namespace dermis::python
