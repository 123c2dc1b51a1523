// SPDX-License-Identifier: MIT
// What the library says during a test.
#pragma once

#include <string>
#include <vector>

#include "base/core/hooks.h"

namespace dermis::tests {

/// Collects the lines of the current thread while it exists; none of them is printed.
class LogLines {
 public:
  std::vector<std::string> all, notes, warnings;

 private:
  HookScope scope_{Hooks{.log = [this](LogLevel level, const std::string& line) {
    all.push_back(line);
    (level == LogLevel::note ? notes : warnings).push_back(line);
  }}};
};

}  // namespace dermis::tests
