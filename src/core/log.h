// SPDX-License-Identifier: MIT
// Warnings and notes for the user. They go to stderr, one line each, or to a sink that a test or an engine
// sets.
#pragma once

#include <fmt/format.h>

#include <functional>
#include <string>

namespace dermis {

enum class LogLevel { note, warning };
using LogSink = std::function<void(LogLevel, const std::string& line)>;

/// Replaces the sink (default: stderr, "dermis: warning: ..."); an empty one restores the default. Returns
/// the former sink.
LogSink set_log_sink(LogSink sink);
void log_line(LogLevel level, const std::string& line);

template <class... Args>
void warn(fmt::format_string<Args...> format, Args&&... args) {
  log_line(LogLevel::warning, fmt::format(format, std::forward<Args>(args)...));
}
template <class... Args>
void note(fmt::format_string<Args...> format, Args&&... args) {
  log_line(LogLevel::note, fmt::format(format, std::forward<Args>(args)...));
}

}  // namespace dermis
