// SPDX-License-Identifier: MIT
// A profile measured or computed elsewhere: R(r) from a table.
#pragma once

#include <array>
#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

#include "tissue/profile/radial.h"

namespace dermis::profile {

/// Linear between samples; constant below the first radius, 0 past the last.
class Tabulated final : public RadialProfile {
 public:
  /// Takes at least 2 strictly rising radii >= 0 and as many values >= 0, at least one > 0; throws InputError
  /// (place `where`) otherwise.
  Tabulated(std::vector<double> radii_mm, std::vector<double> values_per_mm2, const std::string& where);

  double at(double radius_mm) const override;
  /// Returns the exact integral of the linear pieces.
  double total() const override { return total_; }
  double inner_mm() const override;
  double outer_mm() const override { return radii_mm_.back() / 10; }
  std::span<const double> break_points_mm() const override { return radii_mm_; }
  std::string name() const override { return "table"; }

 private:
  std::vector<double> radii_mm_, values_;
  double total_ = 0;
};

/// Parses CSV: the header line `r_mm,R,G,B`, then at most 100,000 rows with rising radii in mm and R in
/// 1/mm^2; lines that start with # are skipped. Throws InputError (names the line) for a wrong header, not
/// four numbers, a value that is negative or not finite, radii that do not rise, fewer than two rows.
std::array<ProfilePtr, 3> parse_csv(std::string_view text, const std::string& where);
/// Parses a file of at most 32 MiB; throws InputError (place: its name) also if it cannot be read.
std::array<ProfilePtr, 3> load_csv(const std::filesystem::path& path);

}  // namespace dermis::profile
