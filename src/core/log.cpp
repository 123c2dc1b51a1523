// SPDX-License-Identifier: MIT
#include "core/log.h"

#include <cstdio>
#include <mutex>
#include <utility>

namespace dermis {
namespace {

std::mutex mutex;
LogSink& current() {
  static LogSink sink;
  return sink;
}

}  // namespace

LogSink set_log_sink(LogSink sink) {
  const std::lock_guard lock(mutex);
  return std::exchange(current(), std::move(sink));
}

void log_line(LogLevel level, const std::string& line) {
  const std::lock_guard lock(mutex);
  if (current()) return current()(level, line);
  std::fputs(fmt::format("dermis: {}{}\n", level == LogLevel::warning ? "warning: " : "", line).c_str(),
             stderr);
}

}  // namespace dermis
