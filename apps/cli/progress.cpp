// SPDX-License-Identifier: MIT
#include "cli/progress.h"

#include <fmt/format.h>
#include <unistd.h>

#include <algorithm>
#include <csignal>

namespace dermis::cli {
namespace {

std::atomic<bool> interrupted{false};
static_assert(std::atomic<bool>::is_always_lock_free);  // so that a signal handler may set it

// The first one ends with what there is; the second one ends at once.
void on_signal(int number) {
  interrupted = true;
  std::signal(number, SIG_DFL);
}

}  // namespace

std::atomic<bool>& catch_interrupts() {
  std::signal(SIGINT, on_signal);
  std::signal(SIGTERM, on_signal);
  return interrupted;
}

CatchInterrupts::~CatchInterrupts() {
  std::signal(SIGINT, SIG_DFL);
  std::signal(SIGTERM, SIG_DFL);
}

const std::atomic<bool>& interrupted_flag() { return interrupted; }

Hooks terminal_hooks() {
  const auto show = [shown = std::string()](const WorkProgress& work) mutable {
    const std::string line = fmt::format("{}: {} %", work.what, static_cast<int>(100 * work.share));
    if (line != shown) show_line(line);
    shown = line;
    return true;
  };
  return {.log = {}, .progress = show, .stop = &interrupted};
}

std::string duration(double seconds) {
  const auto s = static_cast<long>(std::min(seconds, 1e9));
  if (s >= 3600) return fmt::format("{} h {:02} min", s / 3600, s / 60 % 60);
  return s >= 60 ? fmt::format("{} min {:02} s", s / 60, s % 60) : fmt::format("{} s", s);
}

void show_line(const std::string& what) {
  if (::isatty(STDERR_FILENO)) fmt::print(stderr, "\r\033[K{}", what);
}

Progress::Progress(double total_work) : total_(total_work) {}

void Progress::show(const std::string& what) {
  const double gone_s = std::chrono::duration<double>(std::chrono::steady_clock::now() - start_).count();
  std::string left;
  if (done_ > 0) left = fmt::format(", {} left", duration(gone_s / done_ * std::max(total_ - done_, 0.0)));
  show_line(fmt::format("{}: {:.0f} %, {} gone{}", what, 100 * std::min(done_ / total_, 1.0),
                        duration(gone_s), left));
}

void Progress::clear() { show_line(""); }

}  // namespace dermis::cli
