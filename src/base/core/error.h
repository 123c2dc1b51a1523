// SPDX-License-Identifier: MIT
// Formatting helpers for the errors of include/dermis/error.h.
#pragma once

#include <fmt/format.h>

#include "dermis/error.h"

namespace dermis {

/// throw input_error(path, "material '{}': roughness must be 0 to 1, got {}", name, value);
template <class... Args>
InputError input_error(const std::string& where, fmt::format_string<Args...> format, Args&&... args) {
  return {where, fmt::format(format, std::forward<Args>(args)...)};
}

template <class... Args>
DeviceError device_error(fmt::format_string<Args...> format, Args&&... args) {
  return DeviceError(fmt::format(format, std::forward<Args>(args)...));
}

}  // namespace dermis
