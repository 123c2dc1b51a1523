// SPDX-License-Identifier: MIT
#include "tissue/profile/table.h"

#include <algorithm>
#include <cmath>

#include "base/core/hooks.h"
#include "base/core/parallel.h"

namespace dermis::profile {

namespace {

constexpr double radii_per_decade = 24;
constexpr double left_out = 5e-4;  // of the light of a channel, at either end
// Beyond these, no skin; keeps the table short where a channel reaches out of all proportion.
constexpr double least_mm = 1e-6, most_mm = 1e5;

}  // namespace

ProfileTable table_of(const std::array<ProfilePtr, 3>& profiles) {
  double low_mm = most_mm, high_mm = least_mm;
  for (const ProfilePtr& profile : profiles) {
    low_mm = std::min(low_mm, std::max(profile->quantile(left_out), least_mm));
    high_mm = std::max(high_mm, std::min(profile->quantile(1 - left_out), most_mm));
  }

  // Radii are whole powers of 10^(1/24), so that tables of different profiles share theirs.
  const auto first = static_cast<int>(std::floor(radii_per_decade * std::log10(low_mm)));
  const auto last = static_cast<int>(std::ceil(radii_per_decade * std::log10(std::max(low_mm, high_mm))));
  const auto count = static_cast<std::size_t>(last - first) + 1;

  ProfileTable table;
  table.reflectance_per_mm2.resize(count);
  table.standard_error_per_mm2.resize(count);
  for (int i = first; i <= last; ++i) table.r_mm.push_back(std::pow(10.0, i / radii_per_decade));

  Steps steps("spread of light in skin", count);
  parallel_for(count, [&](std::size_t i) {
    for (std::size_t c = 0; c < 3; ++c) {
      table.reflectance_per_mm2[i][c] = profiles[c]->at(table.r_mm[i]);
      table.standard_error_per_mm2[i][c] = profiles[c]->standard_error_at(table.r_mm[i]);
    }
    steps.done();
  });
  return table;
}

}  // namespace dermis::profile
