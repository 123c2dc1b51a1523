// SPDX-License-Identifier: MIT
// Runs a program and waits for it. A driver may end or hang the program that uses it: each measurement is a
// process of its own, and the kit goes on.
#pragma once

#include <atomic>
#include <filesystem>
#include <string>
#include <utility>
#include <vector>

namespace dermis::kit {

struct Command {
  std::vector<std::string> words;                              ///< the program first, relative to `folder`
  std::filesystem::path folder;                                ///< where it runs
  std::vector<std::pair<std::string, std::string>> variables;  ///< of its environment, beside ours
  double most_seconds = 600;                                   ///< then it is ended
};

struct Ended {
  int status = -1;         ///< exit status; -1: ended by a signal
  int signal = 0;          ///< that ended it; 0: none
  bool timed_out = false;  ///< was ended because it took too long
  bool stopped = false;    ///< was ended because `stop` was set
  double seconds = 0;      ///< wall clock
  double peak_mb = 0;      ///< largest resident set, 1e6 bytes
  std::string out, err;    ///< its output, the first MiB of each

  bool ok() const { return status == 0 && !timed_out && !stopped; }
  /// Returns one line: the last that it wrote to standard error, or how it was ended. Empty if ok().
  std::string why() const;
};

/// Runs the program until it ends. `stop` and `most_seconds` end it: SIGTERM, then SIGKILL after
/// grace_seconds. It is killed if this process is. A program that cannot be started ends with status 127.
/// Throws InputError if the system allows no process.
Ended run(const Command& command, const std::atomic<bool>& stop);

inline constexpr double grace_seconds = 30;

/// The words as a shell would take them.
std::string quoted(const std::vector<std::string>& words);

}  // namespace dermis::kit
