// SPDX-License-Identifier: MIT
// Curves of points over two logarithmic axes, such as error over cost.
#pragma once

#include <string>
#include <vector>

namespace dermis::report {

struct ChartPoint {
  double x = 0, y = 0;  ///< above 0; others are left out
  std::string name;     ///< shown when pointed at
};

struct PointCurve {
  std::string name;
  std::vector<ChartPoint> points;  ///< joined in this order
};

struct PointChart {
  std::string title, x_name, y_name;
  std::vector<PointCurve> curves;  ///< number i has chart_colour(i)
};

/// An svg element with its legend. Both axes reach over whole decades of what the points have. Empty text if
/// there is no point.
std::string point_chart(const PointChart& chart);

}  // namespace dermis::report
