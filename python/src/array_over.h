// SPDX-License-Identifier: MIT
// NumPy arrays over memory of C++ objects, which they keep: no copies.
#pragma once

#include <nanobind/nanobind.h>
#include <nanobind/ndarray.h>

#include <memory>
#include <utility>

#include "process.h"

namespace dermis::python {

/// An array of height x width x channels over memory that `owner` keeps; height x width if there is one
/// channel.
template <class T>
auto array_over(T* values, int width, int height, int channels, nanobind::handle owner) {
  const std::size_t shape[] = {static_cast<std::size_t>(height), static_cast<std::size_t>(width),
                               static_cast<std::size_t>(channels)};
  return nanobind::ndarray<nanobind::numpy, T>(values, channels == 1 ? 2 : 3, shape, owner);
}

/// An owner that arrays hold, of a C++ object. In a process that was forked it leaves the object alone.
template <class T>
nanobind::capsule keeper(std::shared_ptr<T> kept) {
  auto* const held = new std::shared_ptr<T>(std::move(kept));
  return {held, [](void* p) noexcept {
            if (is_our_process()) delete static_cast<std::shared_ptr<T>*>(p);
          }};
}

}  // namespace dermis::python
