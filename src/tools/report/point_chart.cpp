// SPDX-License-Identifier: MIT
#include "tools/report/point_chart.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "tools/report/charts.h"
#include "tools/report/escape.h"
#include "tools/report/svg.h"

namespace dermis::report {
namespace {

constexpr double chart_width = 640, chart_height = 420, chart_left = 64, chart_right = 628, chart_top = 30,
                 chart_bottom = 368;

bool is_drawn(const ChartPoint& p) { return p.x > 0 && p.y > 0 && std::isfinite(p.x) && std::isfinite(p.y); }

struct Extent {
  double low = std::numeric_limits<double>::infinity(), high = 0;
  void add(double value) { low = std::min(low, value), high = std::max(high, value); }

  /// To powers of ten around it.
  Scale scale(double from, double to) const {
    const double first = std::pow(10, std::floor(std::log10(low) + 1e-9)),
                 last = std::pow(10, std::ceil(std::log10(high) - 1e-9));
    return {.from = from, .to = to, .low = first, .high = std::max(last, 10 * first), .logarithmic = true};
  }
};

std::string chart_axes(const PointChart& chart, const Scale& x, const Scale& y) {
  std::string svg = text({chart_left, 16}, "start", chart.title, "class=\"title\"") +
                    text({(chart_left + chart_right) / 2, chart_height - 14}, "middle", chart.x_name) +
                    text({chart_left, chart_top - 2}, "start", chart.y_name);
  for (const double value : decades(x.low, x.high))
    svg += line({x(value), chart_top}, {x(value), chart_bottom}, "class=\"grid\"") +
           text({x(value), chart_bottom + 16}, "middle", fmt::format("{:g}", value));
  for (const double value : decades(y.low, y.high))
    svg += line({chart_left, y(value)}, {chart_right, y(value)}, "class=\"grid\"") +
           text({chart_left - 6, y(value) + 4}, "end", fmt::format("{:g}", value));
  return svg;
}

std::string chart_curve(const PointCurve& curve, const char* colour, const Scale& x, const Scale& y) {
  std::vector<Point> joined;
  std::string dots;
  for (const ChartPoint& p : curve.points) {
    if (!is_drawn(p)) continue;
    joined.push_back({x(p.x), y(p.y)});
    dots += fmt::format(
        "<circle cx=\"{:.1f}\" cy=\"{:.1f}\" r=\"4\" fill=\"{}\"><title>{}, {}: {}, {}</title></circle>",
        joined.back().x, joined.back().y, colour, escape(curve.name), escape(p.name), number(p.x),
        fmt::format("{:.3g}", p.y));
  }
  if (joined.size() < 2) return dots;
  return polyline(joined, fmt::format("stroke=\"{}\" stroke-width=\"2\"", colour)) + dots;
}

}  // namespace

std::string point_chart(const PointChart& chart) {
  Extent x_extent, y_extent;
  for (const PointCurve& curve : chart.curves)
    for (const ChartPoint& p : curve.points) {
      if (!is_drawn(p)) continue;
      x_extent.add(p.x);
      y_extent.add(p.y);
    }
  if (x_extent.high == 0) return "";

  const Scale x = x_extent.scale(chart_left, chart_right), y = y_extent.scale(chart_bottom, chart_top + 8);
  std::string svg =
      fmt::format("<svg class=\"chart\" viewBox=\"0 0 {} {}\" width=\"{}\" role=\"img\" aria-label=\"{}\">",
                  chart_width, chart_height, chart_width, escape(chart.title)) +
      chart_axes(chart, x, y);
  std::vector<Line> names;
  for (std::size_t i = 0; i < chart.curves.size(); ++i) {
    svg += chart_curve(chart.curves[i], chart_colour(i), x, y);
    names.push_back({.name = chart.curves[i].name, .colour = i, .dashed = false, .values = {}});
  }
  return svg + "</svg>\n" + legend(names);
}

}  // namespace dermis::report
