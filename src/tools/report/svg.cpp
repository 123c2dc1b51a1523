// SPDX-License-Identifier: MIT
#include "tools/report/svg.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "tools/report/escape.h"

namespace dermis::report {
namespace {

std::string with_space(std::string_view style) {
  return style.empty() ? std::string() : fmt::format(" {}", style);
}

}  // namespace

double Scale::operator()(double value) const {
  const double fraction = logarithmic ? std::log(value / low) / std::log(high / low)  //
                                      : (value - low) / (high - low);
  return from + (to - from) * fraction;
}
double Scale::clamped(double value) const { return (*this)(std::clamp(value, low, high)); }
double Scale::value_at(double fraction) const {
  return logarithmic ? low * std::pow(high / low, fraction) : low + (high - low) * fraction;
}

double tick_step(double max, int count) {
  if (!(max > 0) || !std::isfinite(max) || count < 1) return 1;
  const double power = std::pow(10, std::floor(std::log10(max / count)));
  for (const double times : {1.0, 2.0, 5.0})
    if (times * power * count >= max * (1 - 1e-9)) return times * power;
  return 10 * power;
}

std::vector<double> ticks(double max, int count) {
  const double step = tick_step(max, count);
  std::vector<double> values;
  for (int i = 0; i <= count && i * step <= max * (1 + 1e-9); ++i) values.push_back(i * step);
  return values;
}

std::vector<double> decades(double low, double high) {
  std::vector<double> values;
  for (int power = static_cast<int>(std::floor(std::log10(low))); std::pow(10.0, power) <= high; ++power)
    if (std::pow(10.0, power) >= low) values.push_back(std::pow(10.0, power));
  return values;
}

std::string number(double value) { return fmt::format("{:.3g}", value); }

std::string text(Point at, std::string_view anchor, std::string_view words, std::string_view style) {
  return fmt::format("<text x=\"{:.1f}\" y=\"{:.1f}\" text-anchor=\"{}\"{}>{}</text>", at.x, at.y, anchor,
                     with_space(style), escape(words));
}

std::string line(Point from, Point to, std::string_view style) {
  return fmt::format("<line x1=\"{:.1f}\" y1=\"{:.1f}\" x2=\"{:.1f}\" y2=\"{:.1f}\"{}/>", from.x, from.y,
                     to.x, to.y, with_space(style));
}

std::string polyline(const std::vector<Point>& points, std::string_view style) {
  std::string all;
  for (const Point& p : points) all += fmt::format("{:.1f},{:.1f} ", p.x, p.y);
  return fmt::format("<polyline fill=\"none\"{} points=\"{}\"/>", with_space(style), all);
}

}  // namespace dermis::report
