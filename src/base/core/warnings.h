// SPDX-License-Identifier: MIT
// Groups warnings that many objects of one file share: one line says what, how many, and the first three
// names.
#pragma once

#include <string>

#include "base/core/log.h"

namespace dermis {

/// While one exists, warn_of() collects; when the outermost one ends, each kind of warning becomes one line.
/// If an exception ends it, the warnings are dropped, so that an error is one line. Applies to the current
/// thread only.
class WarningGroup {
 public:
  WarningGroup();
  ~WarningGroup();
  WarningGroup(const WarningGroup&) = delete;
  WarningGroup& operator=(const WarningGroup&) = delete;

 private:
  int exceptions_;  ///< in flight at construction
};

/// Warns of one object. `line` is the whole warning for this object alone, printed at once if no WarningGroup
/// exists; `kind` is the text for any number of objects, and groups them.
void warn_of(const std::string& kind, const std::string& name, const std::string& line);

}  // namespace dermis
