// SPDX-License-Identifier: MIT
// The heads that were packed.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace dermis::kit {

struct Heads {
  std::vector<std::string> people;  ///< whole characters: skin, eyes, lashes; relative to the kit
  std::string scan;                 ///< empty: not packed
  static constexpr const char* built_in = "built-in";

  /// The scan, else one of the people, else the built-in head: what is measured.
  const std::string& main() const;
  /// One that is soon loaded: what is only tried out.
  const std::string& light() const;
  /// All that there are; the built-in head, which takes seconds to make, is the last.
  std::vector<std::string> all() const;
};

/// Looks into the folder of the kit.
Heads find_heads(const std::filesystem::path& kit);

}  // namespace dermis::kit
