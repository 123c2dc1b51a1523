// SPDX-License-Identifier: MIT
// Numbers that others published or computed independently, for the tests of optics, profile and gaussians.
#pragma once

#include <array>

namespace dermis::truth {

using Rgb = std::array<double, 3>;

/// Optimal non-negative Gaussian fits of the classical dipole, eta 1.3 (marble 1.5): error in per cent
/// for 2..6 terms, one channel each, from an independent fitter. Order of the rows: the materials of
/// optics::jensen_materials() without spectralon, red, green, blue.
struct FitRow {
  const char* material;
  int channel;
  std::array<double, 5> error_percent;
};
extern const std::array<FitRow, 33> fit_rows;

/// Totals of the classical dipole in closed form, computed independently, rounded to 4 digits; and the column
/// that was printed with the coefficients in 2001.
struct TotalRow {
  const char* material;
  Rgb computed;
  Rgb published;
};
extern const std::array<TotalRow, 12> totals;

}  // namespace dermis::truth
