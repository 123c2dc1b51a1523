// SPDX-License-Identifier: MIT
// Warnings and notes for the user. They go to the sink of the hooks of this thread (base/core/hooks.h), else
// to standard error.
#pragma once

#include <fmt/format.h>

#include <string>

#include "dermis/hooks.h"

namespace dermis {

/// Passes one line to the log.
void log_line(LogLevel level, const std::string& line);

/// Warns, unless the call of the library that this thread works for has warned of the same kind before.
void warn_once(const std::string& kind, const std::string& line);

template <class... Args>
void warn(fmt::format_string<Args...> format, Args&&... args) {
  log_line(LogLevel::warning, fmt::format(format, std::forward<Args>(args)...));
}
template <class... Args>
void note(fmt::format_string<Args...> format, Args&&... args) {
  log_line(LogLevel::note, fmt::format(format, std::forward<Args>(args)...));
}

}  // namespace dermis
