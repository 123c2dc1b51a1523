// SPDX-License-Identifier: MIT
// A profile that someone measured or computed elsewhere: R(r) from a table.
#pragma once

#include <array>
#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

#include "profile/radial.h"

namespace dermis::profile {

/// Straight lines between the samples; constant below the first radius, 0 past the last.
class Tabulated final : public RadialProfile {
 public:
  /// radii_mm: >= 0, strictly rising, at least 2; values_per_mm2: as many, >= 0, one at least > 0 (InputError
  /// otherwise, place `where`).
  Tabulated(std::vector<double> radii_mm, std::vector<double> values_per_mm2, const std::string& where);

  double at(double radius_mm) const override;
  /// Exact: the integral of r R over each straight piece.
  double total() const override { return total_; }
  double inner_mm() const override;
  double outer_mm() const override { return radii_mm_.back() / 10; }
  std::span<const double> break_points_mm() const override { return radii_mm_; }
  std::string name() const override { return "table"; }

 private:
  std::vector<double> radii_mm_, values_;
  double total_ = 0;
};

/// CSV with the header line `r_mm,R,G,B`, radii in mm and rising, R in 1/mm^2; at most 100,000 rows below it;
/// lines that start with # are skipped. InputError names the line: wrong header, not four numbers, negative,
/// not finite, not rising, fewer than two rows.
std::array<ProfilePtr, 3> parse_csv(std::string_view text, const std::string& where);
/// The same from a file of at most 32 MiB, whose name is the place; also InputError if it cannot be read.
std::array<ProfilePtr, 3> load_csv(const std::filesystem::path& path);

}  // namespace dermis::profile
