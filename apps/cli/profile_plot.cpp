// SPDX-License-Identifier: MIT
#include "cli/profile_plot.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <functional>

#include "base/core/channels.h"
#include "image/colour.h"
#include "tools/report/svg.h"

namespace dermis::cli {
namespace {

using gaussians::Term;
using report::Point;

constexpr double width = 900, left = 80, right = 20;
// Legible on white, and apart for the colour-blind by their order in the legend.
constexpr const char* colour[] = {"#c0392b", "#1e8449", "#2455a4"};
constexpr int samples = 240;  // of a curve

std::string text_at(Point at, const std::string& text, const char* anchor = "start",
                    const char* fill = "#333") {
  return report::text(at, anchor, text, fmt::format("fill=\"{}\"", fill)) + "\n";
}

/// The look of a line.
struct Stroke {
  const char* colour;
  const char* dash;
  double thickness;

  std::string style() const {
    return fmt::format("stroke=\"{}\" stroke-width=\"{}\" stroke-dasharray=\"{}\"", colour, thickness, dash);
  }
};

/// A panel with a logarithmic radius axis.
struct Panel {
  double top, height;
  report::Scale x, y;

  Panel(double top_, double height_, double r_low, double r_high, double y_low, double y_high)
      : top(top_),
        height(height_),
        x{.from = left, .to = width - right, .low = r_low, .high = r_high, .logarithmic = true},
        y{.from = top + height, .to = top, .low = y_low, .high = y_high} {}

  std::string frame(const std::string& label, bool radii) const {
    std::string svg = fmt::format(
        "<rect x=\"{:.1f}\" y=\"{:.1f}\" width=\"{:.1f}\" height=\"{:.1f}\" fill=\"none\" "
        "stroke=\"#999\"/>\n",
        left, top, width - left - right, height);
    for (const double r : report::decades(x.low, x.high)) {
      svg += report::line({x(r), top}, {x(r), top + height}, "stroke=\"#ddd\"") + "\n";
      if (radii) svg += text_at({x(r), top + height + 16}, fmt::format("{:g} mm", r), "middle");
    }
    for (const double fraction : {0.0, 0.5, 1.0}) {
      const double value = y.value_at(fraction);
      svg += text_at({left - 6, y(value) + 4}, fmt::format("{:.2g}", value), "end");
    }
    return svg + text_at({(left + width - right) / 2, top + 18}, label, "middle");
  }

  std::string curve(const std::function<double(double)>& f, const Stroke& stroke) const {
    std::vector<Point> points;
    for (int i = 0; i <= samples; ++i) {
      const double r = x.value_at(static_cast<double>(i) / samples);
      points.push_back({x(r), y.clamped(f(r))});
    }
    return report::polyline(points, stroke.style()) + "\n";
  }
};

double scaled(const profile::RadialProfile& profile, double r) { return r * profile.at(r) / profile.total(); }
double scaled(const std::vector<Term>& terms, double r) { return r * gaussians::evaluate(terms, r); }

int display(double linear) { return image::linear_to_srgb8(static_cast<float>(linear)); }

/// One strip of the colours across the edge.
std::string strip(const PlottedSum& sum, double top, double reach_mm) {
  std::string svg;
  constexpr int steps = 160;
  const double step = (width - left - right) / steps;
  for (int i = 0; i < steps; ++i) {
    const double x_mm = -reach_mm / 4 + (i + 0.5) / steps * reach_mm * 1.25;
    svg += fmt::format(
        "<rect x=\"{:.2f}\" y=\"{:.1f}\" width=\"{:.2f}\" height=\"34\" fill=\"rgb({},{},{})\"/>\n",
        left + i * step, top, step + 0.5, display(gaussians::edge_response(sum.channels[0], x_mm)),
        display(gaussians::edge_response(sum.channels[1], x_mm)),
        display(gaussians::edge_response(sum.channels[2], x_mm)));
  }
  return svg + text_at({width - right - 8, top + 22}, sum.label, "end", "#fff");
}

struct Extent {
  double r_low = 1e300, r_high = 0, peak = 0, residual = 0;
};

Extent extent_of(const ProfilePlot& plot) {
  Extent scale;
  for (int c = 0; c < 3; ++c) {
    const profile::RadialProfile& profile = *plot.profiles[c];
    scale.r_low =
        std::min(scale.r_low, profile.has_pole() ? std::sqrt(gaussians::core_variance_mm2(profile)) / 2
                                                 : std::max(profile.quantile(0.003), 1e-6));
    scale.r_high = std::max(scale.r_high, std::min(profile.quantile(0.998), 1e5));
  }
  if (!(scale.r_high > 2 * scale.r_low)) scale.r_high = 2 * scale.r_low;

  // Find the highest curve and the largest residual, at the radii of the curves.
  for (int c = 0; c < 3; ++c)
    for (int i = 0; i <= samples; ++i) {
      const double r = scale.r_low * std::pow(scale.r_high / scale.r_low, static_cast<double>(i) / samples);
      const double exact = scaled(*plot.profiles[c], r), fitted = scaled(plot.fit.channels[c], r);
      scale.peak = std::max({scale.peak, exact, fitted});
      for (const PlottedSum& other : plot.others)
        scale.peak = std::max(scale.peak, scaled(other.channels[c], r));
      scale.residual = std::max(scale.residual, std::abs(exact - fitted));
    }

  return scale;
}

constexpr const char* dashed = "7 4";
constexpr const char* dots[] = {"2 3", "1 5", "6 3 1 3"};

/// Names of the lines, beneath the names of the channels: at the right every curve has come down.
std::string legend(const ProfilePlot& plot, const Panel& panel) {
  constexpr double line_right = width - right - 10, line_left = line_right - 40;
  std::string svg;
  double y = panel.top + 76;
  const auto entry = [&](const std::string& label, const char* dash, double thickness) {
    svg += text_at({line_left - 8, y}, label, "end");
    svg +=
        report::line({line_left, y - 4}, {line_right, y - 4}, Stroke{"#333", dash, thickness}.style()) + "\n";
    y += 17;
  };
  entry("profile", "none", 1.6);
  entry(plot.fit.label, dashed, 2.4);
  for (std::size_t i = 0; i < plot.others.size() && i < std::size(dots); ++i)
    entry(plot.others[i].label, dots[i], 1.4);
  return svg;
}

double wide_reach_mm(const PlottedSum& sum) {
  double variance = 0;
  for (const auto& terms : sum.channels)
    for (const Term& term : terms)
      if (term.weight > 0.02) variance = std::max(variance, term.variance_mm2);
  return 2.5 * std::sqrt(variance);
}

}  // namespace

std::string profile_svg(const ProfilePlot& plot) {
  const Extent scale = extent_of(plot);
  const Panel main{50, 300, scale.r_low, scale.r_high, 0, 1.05 * scale.peak};
  const double limit = std::max(scale.residual, 1e-12) * 1.05;
  const Panel below{400, 120, scale.r_low, scale.r_high, -limit, limit};
  const double strips_top = 580, height = strips_top + 44 * static_cast<double>(1 + plot.others.size()) + 40;

  std::string svg = fmt::format(
      "<svg xmlns=\"http://www.w3.org/2000/svg\" viewBox=\"0 0 {0} {1}\" width=\"{0}\" height=\"{1}\" "
      "font-family=\"sans-serif\" "
      "font-size=\"13\">\n"
      "<rect width=\"{0}\" height=\"{1}\" fill=\"#fff\"/>\n",
      width, height);
  svg += text_at({left, 30}, plot.title);
  svg += main.frame("r R(r) / total   [1/mm]", false) + below.frame("residual of the fit   [1/mm]", true);

  for (int c = 0; c < 3; ++c) {
    const auto exact = [&](double r) { return scaled(*plot.profiles[c], r); };
    const auto fitted = [&](double r) { return scaled(plot.fit.channels[c], r); };
    svg += main.curve(exact, {colour[c], "none", 1.6}) + main.curve(fitted, {colour[c], dashed, 2.4});
    for (std::size_t i = 0; i < plot.others.size() && i < std::size(dots); ++i)
      svg += main.curve([&](double r) { return scaled(plot.others[i].channels[c], r); },
                        {colour[c], dots[i], 1.4});
    svg += below.curve([&](double r) { return exact(r) - fitted(r); }, {colour[c], "none", 1.4});
    svg += text_at({width - right - 10, main.top + 18 + 17 * c}, channel_names[c], "end", colour[c]);
  }
  svg += legend(plot, main);

  double reach_mm = wide_reach_mm(plot.fit);
  for (const PlottedSum& other : plot.others) reach_mm = std::max(reach_mm, wide_reach_mm(other));
  svg += text_at(
      {left, strips_top - 10},
      fmt::format("light that bleeds from a white edge into the dark, {:.3g} mm wide, edge at a fifth",
                  1.25 * reach_mm));
  svg += strip(plot.fit, strips_top, reach_mm);
  for (std::size_t i = 0; i < plot.others.size(); ++i)
    svg += strip(plot.others[i], strips_top + 44 * static_cast<double>(i + 1), reach_mm);

  return svg + "</svg>\n";
}

}  // namespace dermis::cli
