// SPDX-License-Identifier: MIT
// Parts of charts: the scale of an axis, its ticks, and the elements of SVG.
// Positions are in the units of the picture, which are pixels where there is room. `style` is the rest of an
// element's attributes, as they stand in the file.
#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace dermis::report {

/// Where the values of an axis lie: `low` at `from`, `high` at `to`, which may be less than `from`.
struct Scale {
  double from = 0, to = 1;
  double low = 0, high = 1;  ///< above 0 if logarithmic
  bool logarithmic = false;

  /// Returns the position of a value, which may lie outside.
  double operator()(double value) const;
  /// Returns the position of the nearest value within low to high.
  double clamped(double value) const;
  /// Returns the value at a fraction of the way from low to high.
  double value_at(double fraction) const;
};

/// Returns 1, 2 or 5 times a power of ten, such that at most `count` steps reach up to `max`.
double tick_step(double max, int count);
/// Returns the multiples of tick_step(max, count) from 0 to max.
std::vector<double> ticks(double max, int count);
/// Returns the powers of ten from low to high.
std::vector<double> decades(double low, double high);

/// Returns a number as it stands at an axis, with three digits.
std::string number(double value);

struct Point {
  double x = 0, y = 0;
};

/// An SVG text; words are escaped here. anchor: start, middle or end.
std::string text(Point at, std::string_view anchor, std::string_view words, std::string_view style = {});
std::string line(Point from, Point to, std::string_view style);
/// Not filled.
std::string polyline(const std::vector<Point>& points, std::string_view style);

}  // namespace dermis::report
