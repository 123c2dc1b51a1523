// SPDX-License-Identifier: MIT
// Lines of a command on standard error beside its progress: two lines at most, all of them with --verbose.
#pragma once

#include <CLI/CLI.hpp>
#include <string>
#include <vector>

#include "base/core/hooks.h"

namespace dermis::cli {

/// While it lives, the first warning or note is printed at once and the others wait.
class BriefLog {
 public:
  /// Adds the options of the command that runs to the settings that a line names. `app` outlives this.
  explicit BriefLog(const CLI::App& app);
  BriefLog(const BriefLog&) = delete;
  BriefLog& operator=(const BriefLog&) = delete;

  /// The command has done its work: prints what waits if that is one line, else how many there are.
  void finish();

 private:
  void take(LogLevel level, const std::string& line);
  const CLI::App* app_;
  bool said_one_ = false;
  std::vector<std::string> held_;
  HookScope scope_;
};

/// --verbose, which commands that open a scene have.
bool& verbose();

}  // namespace dermis::cli
