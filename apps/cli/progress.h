// SPDX-License-Identifier: MIT
// Long work: how far it is, on a terminal only, and Ctrl-C that ends it in order.
#pragma once

#include <atomic>
#include <chrono>
#include <string>

#include "dermis/hooks.h"

namespace dermis::cli {

/// From now on the first Ctrl-C (or SIGTERM) sets the returned flag, the second one ends the program at once.
std::atomic<bool>& catch_interrupts();

/// The same as long as this lives; then a signal ends the program at once again.
class CatchInterrupts {
 public:
  CatchInterrupts() { catch_interrupts(); }
  CatchInterrupts(const CatchInterrupts&) = delete;
  CatchInterrupts& operator=(const CatchInterrupts&) = delete;
  ~CatchInterrupts();
};

/// The flag that it sets.
const std::atomic<bool>& interrupted_flag();

/// Shows how far long work is, as a line that is rewritten, and ends it at an interrupt.
Hooks terminal_hooks();

/// "2 h 05 min", "3 min 20 s", "7 s".
std::string duration(double seconds);

/// One line on standard error that is rewritten; nothing where standard error is no terminal. Empty: it is
/// cleared.
void show_line(const std::string& what);

/// The same with how far the work is.
class Progress {
 public:
  explicit Progress(double total_work);
  Progress(const Progress&) = delete;
  Progress& operator=(const Progress&) = delete;
  ~Progress() { clear(); }

  /// Shows the work that comes now. The time left is that of the work so far, scaled.
  void show(const std::string& what);
  void done(double work) { done_ += work; }
  void clear();  ///< before anything else is printed

 private:
  double total_, done_ = 0;
  std::chrono::steady_clock::time_point start_ = std::chrono::steady_clock::now();
};

}  // namespace dermis::cli
