// SPDX-License-Identifier: MIT
#include "cli/bench/statistics.h"

#include <algorithm>
#include <cmath>

#include "base/core/assert.h"

namespace dermis::cli::bench {

Spread spread_of(std::vector<double> values) {
  DERMIS_ASSERT(!values.empty());
  std::sort(values.begin(), values.end());
  const std::size_t n = values.size();
  return {.median = n % 2 ? values[n / 2] : (values[n / 2 - 1] + values[n / 2]) / 2,
          .min = values.front(),
          .max = values.back()};
}

Comparison compare_times(const std::vector<double>& before, const std::vector<double>& after) {
  const Spread a = spread_of(before), b = spread_of(after);
  Comparison found{.ratio = a.median > 0 ? b.median / a.median : 1};
  const double gap = b.min > a.max ? b.min - a.max : a.min > b.max ? a.min - b.max : 0;
  if (gap <= 0) return found;
  found.change = b.min > a.max ? Change::slower : Change::faster;
  found.beyond = a.median > 0 ? gap / a.median : 0;
  return found;
}

double chance(std::size_t before, std::size_t after) {
  const auto n = static_cast<double>(before), m = static_cast<double>(after);
  return std::exp(std::lgamma(n + 1) + std::lgamma(m + 1) - std::lgamma(n + m + 1));
}

}  // namespace dermis::cli::bench
