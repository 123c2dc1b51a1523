// SPDX-License-Identifier: MIT
#include <algorithm>
#include <cmath>

#include "cli/layout.h"

namespace dermis::cli {
namespace {

constexpr double apart_radii = 1.6;       // as heads of camera.heads
constexpr double rows_apart_radii = 2.0;  // a head is higher than wide: its sphere ends at chin and crown

/// Returns places along a line, each this many radii of the larger neighbour from the one before.
std::vector<double> line_m(const std::vector<double>& radii_m, double apart) {
  std::vector<double> places(radii_m.size(), 0);
  for (std::size_t i = 1; i < radii_m.size(); ++i)
    places[i] = places[i - 1] + apart * std::max(radii_m[i - 1], radii_m[i]);
  return places;
}

}  // namespace

std::vector<std::array<double, 2>> places_m(Layout layout, const std::vector<double>& radii_m) {
  const std::size_t count = radii_m.size();
  const auto side = static_cast<std::size_t>(std::ceil(std::sqrt(static_cast<double>(count))));
  const std::size_t columns = layout == Layout::row ? count : side;

  // A column is as wide as its largest head, and a row as high.
  std::vector<double> of_columns(columns, 0), of_rows(columns == 0 ? 0 : (count + columns - 1) / columns, 0);
  for (std::size_t i = 0; i < count; ++i) {
    of_columns[i % columns] = std::max(of_columns[i % columns], radii_m[i]);
    of_rows[i / columns] = std::max(of_rows[i / columns], radii_m[i]);
  }
  const std::vector<double> right = line_m(of_columns, apart_radii), down = line_m(of_rows, rows_apart_radii);

  std::vector<std::array<double, 2>> places(count);
  const std::size_t middle = count / 2;
  for (std::size_t i = 0; i < count; ++i)
    places[i] = {right[i % columns] - right[middle % columns], down[middle / columns] - down[i / columns]};
  return places;
}

}  // namespace dermis::cli
