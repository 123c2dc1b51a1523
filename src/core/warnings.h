// SPDX-License-Identifier: MIT
// Warnings that many things of one file may share: one line then says what, how many, and the first three
// names, each once.
#pragma once

#include <string>

#include "core/log.h"

namespace dermis {

/// While one lives, warn_of() gathers; when the outermost one ends, each kind of warning becomes one line.
/// What was gathered is dropped if an exception ends it: a refusal is one line. Of this thread alone.
class WarningGroup {
 public:
  WarningGroup();
  ~WarningGroup();
  WarningGroup(const WarningGroup&) = delete;
  WarningGroup& operator=(const WarningGroup&) = delete;

 private:
  int exceptions_;  ///< in flight when it began
};

/// Warns of one thing. `line` is the whole warning for it alone, and said at once where no WarningGroup
/// lives; `kind` says the same of any number of things, and warnings are grouped by it.
void warn_of(const std::string& kind, const std::string& name, const std::string& line);

}  // namespace dermis
