// SPDX-License-Identifier: MIT
// Answers a name that nothing has: the names that there are, and the one that was probably meant.
#pragma once

#include <initializer_list>
#include <string>
#include <string_view>
#include <vector>

namespace dermis {

/// Names to choose from; views of what the caller holds.
class KnownNames {
 public:
  /// A list of texts, or a map by them.
  template <class Range>
  KnownNames(const Range& names) {  // NOLINT(google-explicit-constructor)
    for (const auto& name : names) {
      if constexpr (requires { name.first; })
        names_.emplace_back(name.first);
      else
        names_.emplace_back(name);
    }
  }
  KnownNames(std::initializer_list<std::string_view> names) : names_(names) {}

  const std::vector<std::string_view>& all() const { return names_; }

 private:
  std::vector<std::string_view> names_;
};

/// Returns the name that a word most likely stands for, empty if none is near. It has the fewest typing
/// errors, at most one in three letters and three in all, else it is the shortest that begins with the word.
/// Capitals, leading dashes and '_' for '-' are no errors.
std::string_view nearest_name(std::string_view word, const KnownNames& names);

/// Returns "; did you mean 'depth'?", or nothing if no name is near.
std::string did_you_mean(std::string_view word, const KnownNames& names);

/// Returns "there are: alpha, depth, tiles; did you mean 'depth'?" on one line, a long list cut; "there are
/// none" without names.
std::string listed_names(std::string_view word, const KnownNames& names);

/// Returns "'dept' is not known; there are: alpha, depth, tiles; did you mean 'depth'?".
std::string unknown_name(std::string_view word, const KnownNames& names);

}  // namespace dermis
