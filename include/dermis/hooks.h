// SPDX-License-Identifier: MIT
/// Messages and progress of the library while it works, and a way for the caller to end the work.
///
///   dermis::Hooks hooks;
///   hooks.log = [&](dermis::LogLevel, const std::string& line) { engine.log(line); };
///   hooks.progress = [&](const dermis::WorkProgress& work) { return !splash.cancelled(work.share); };
///   const dermis::Scene scene = dermis::Scene::load("head.glb", {}, hooks);
///
/// Each call that takes hooks uses its own; nothing is global. The library calls them from any of the threads
/// that work for that call, but never from two of them at once. A hook may call the library; that call has
/// hooks of its own, or none.
#pragma once

#include <atomic>
#include <functional>
#include <string>

#include "dermis/cancelled.h"

namespace dermis {

/// note: nothing is wrong. warning: the result may not be what the caller expects.
enum class LogLevel { note, warning };
/// Receives one line, without a line end. Must not throw: an exception is dropped.
using LogSink = std::function<void(LogLevel level, const std::string& line)>;

/// Work that may take longer than a second.
struct WorkProgress {
  std::string what;  ///< "occlusion of the surroundings"
  double share = 0;  ///< of this work that is done, 0 to 1, rising while `what` stays the same
};

/// All members may be empty.
struct Hooks {
  /// Receives warnings and notes. Empty: standard error, as "dermis: LINE" or "dermis: warning: LINE".
  LogSink log{};
  /// Receives the progress of long work. Returns false to end the work: the call throws Cancelled. An
  /// exception ends it too, and reaches the caller; one of dermis or of memory may get the name of a file.
  std::function<bool(const WorkProgress&)> progress{};
  /// Ends long work as `progress` does: another thread or a signal sets it to true. Parallel loops look at it
  /// more often than progress is told. Not owned: outlives whoever was given the hooks.
  const std::atomic<bool>* stop = nullptr;
};

}  // namespace dermis
