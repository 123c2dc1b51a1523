// SPDX-License-Identifier: MIT
// Repeated times, what they say, and whether two sets of them differ.
#pragma once

#include <vector>

namespace dermis::cli::bench {

struct Spread {
  double median = 0, min = 0, max = 0;
};
/// At least one value. An even number of them: the mean of the middle two.
Spread spread_of(std::vector<double> values);

enum class Change { none, slower, faster };

/// Two sets of times of the same thing. They differ when they do not overlap: every new one is above (or
/// below) every old one. By chance that happens rarely, see chance(), and one stray time on either side only
/// ever hides a change, it makes none.
struct Comparison {
  Change change = Change::none;
  double ratio = 1;   ///< of the medians, new over old
  double beyond = 0;  ///< the gap between the sets as a share of the old median; 0 if they overlap
};
Comparison compare_times(const std::vector<double>& before, const std::vector<double>& after);

/// Returns the chance of one of the two directions if nothing has changed: 1 over the number of ways to
/// choose which of all times are the old ones.
double chance(std::size_t before, std::size_t after);

}  // namespace dermis::cli::bench
