// SPDX-License-Identifier: MIT
#include "cli/charts.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <numeric>

#include "cli/html.h"

namespace dermis::cli::html {
namespace {

// Okabe, Ito: Color Universal Design, 2008; without black, with a grey.
constexpr std::array colours{"#56b4e9", "#e69f00", "#009e73", "#f0e442",
                             "#cc79a7", "#d55e00", "#8f8fff", "#999999"};

// Of a line chart, in units that are pixels where there is room.
constexpr double width = 330, height = 220, left = 38, right = 318, top = 28, bottom = 178;

std::string text(double x, double y, const char* anchor, const std::string& words, const char* kind = "") {
  return fmt::format("<text x=\"{:.1f}\" y=\"{:.1f}\" text-anchor=\"{}\"{}>{}</text>", x, y, anchor, kind,
                     escape(words));
}

std::string number(double value) { return fmt::format("{:.3g}", value); }

std::string axes(const LineChart& chart) {
  std::string svg = text(left, 14, "start", chart.title, " class=\"title\"") +
                    text((left + right) / 2, height - 6, "middle", chart.x_name);
  const double step = tick_step(chart.y_max, 6);
  for (int i = 0; i * step <= chart.y_max * (1 + 1e-9); ++i) {
    const double y = bottom - (bottom - top) * i * step / chart.y_max;
    svg += fmt::format("<line class=\"grid\" x1=\"{}\" y1=\"{:.1f}\" x2=\"{}\" y2=\"{:.1f}\"/>", left, y,
                       right, y) +
           text(left - 6, y + 4, "end", number(i * step));
  }
  return svg;
}

double x_of(const LineChart& chart, std::size_t i) {
  const auto n = static_cast<double>(chart.x.size());
  return left + (right - left) * (static_cast<double>(i) + 0.5) / n;
}

double y_of(const LineChart& chart, double value) {
  return bottom - (bottom - top) * std::clamp(value / chart.y_max, 0.0, 1.0);
}

std::string dash(const Line& line) { return line.dashed ? " stroke-dasharray=\"5 4\"" : ""; }

std::string drawn(const LineChart& chart, const Line& line) {
  std::string svg, points;
  // Close the line that has been drawn so far: a missing value leaves a gap.
  const auto end = [&] {
    if (!points.empty())
      svg += fmt::format("<polyline fill=\"none\" stroke=\"{}\" stroke-width=\"2\"{} points=\"{}\"/>",
                         chart_colour(line.colour), dash(line), points);
    points.clear();
  };

  std::string dots;
  for (std::size_t i = 0; i < std::min(line.values.size(), chart.x.size()); ++i) {
    const std::optional<double> value = line.values[i];
    if (!value || !std::isfinite(*value)) {
      end();
      continue;
    }

    const double x = x_of(chart, i), y = y_of(chart, *value);
    points += fmt::format("{:.1f},{:.1f} ", x, y);
    dots += fmt::format(
        "<circle cx=\"{:.1f}\" cy=\"{:.1f}\" r=\"3\" fill=\"{}\"><title>{}, {}: {}</title></circle>", x, y,
        chart_colour(line.colour), escape(line.name), escape(chart.x[i]), number(*value));
  }

  end();
  return svg + dots;
}

}  // namespace

const char* chart_colour(std::size_t number) { return colours[number % colours.size()]; }

double tick_step(double max, int count) {
  if (!(max > 0) || !std::isfinite(max) || count < 1) return 1;
  const double power = std::pow(10, std::floor(std::log10(max / count)));
  for (const double times : {1.0, 2.0, 5.0})
    if (times * power * count >= max * (1 - 1e-9)) return times * power;
  return 10 * power;
}

std::string line_chart(const LineChart& chart) {
  std::string svg =
      fmt::format("<svg class=\"chart\" viewBox=\"0 0 {} {}\" width=\"{}\" role=\"img\" aria-label=\"{}\">",
                  width, height, width, escape(chart.title)) +
      axes(chart);
  for (std::size_t i = 0; i < chart.x.size(); ++i)
    svg += text(x_of(chart, i), bottom + 16, "middle", chart.x[i]);
  for (const Line& line : chart.lines) svg += drawn(chart, line);
  return svg + "</svg>\n";
}

std::string bar_chart(const BarChart& chart) {
  constexpr double row = 24, name_end = 96, bars = 104, full = 560, all = 760;

  double most = 0;
  for (const Bar& bar : chart.bars)
    most = std::max(most, std::accumulate(bar.parts.begin(), bar.parts.end(), 0.0));

  std::string svg = fmt::format("<svg class=\"chart\" viewBox=\"0 0 {} {}\" width=\"{}\" role=\"img\">", all,
                                row * static_cast<double>(chart.bars.size()) + 4, all);
  double y = 2;
  for (const Bar& bar : chart.bars) {
    svg += text(name_end, y + 15, "end", bar.name);
    double x = bars, sum = 0;
    for (std::size_t part = 0; part < bar.parts.size(); ++part) {
      sum += bar.parts[part];
      const double wide = most > 0 ? full * bar.parts[part] / most : 0;
      if (wide > 0)
        svg += fmt::format(
            "<rect x=\"{:.2f}\" y=\"{:.1f}\" width=\"{:.2f}\" height=\"{}\" fill=\"{}\"><title>{}: {} "
            "{}</title></rect>",
            x, y, wide, row - 5, chart_colour(part),
            escape(part < chart.parts.size() ? chart.parts[part] : ""), number(bar.parts[part]),
            escape(chart.unit));
      x += wide;
    }

    svg += text(x + 6, y + 15, "start",
                fmt::format("{} {}", sum >= 100 ? fmt::format("{:.0f}", sum) : number(sum), chart.unit));
    y += row;
  }
  return svg + "</svg>\n";
}

std::string legend(const std::vector<Line>& lines) {
  std::string html = "<p class=\"legend\">";
  for (const Line& line : lines)
    html += fmt::format(
        "<span><svg width=\"26\" height=\"10\"><line x1=\"0\" y1=\"5\" x2=\"26\" y2=\"5\" stroke=\"{}\" "
        "stroke-width=\"2\"{}/></svg> "
        "{}</span>",
        chart_colour(line.colour), dash(line), escape(line.name));
  return html + "</p>\n";
}

std::string legend(const std::vector<std::string>& parts) {
  std::string html = "<p class=\"legend\">";
  for (std::size_t part = 0; part < parts.size(); ++part)
    html += fmt::format(
        "<span><svg width=\"12\" height=\"12\"><rect width=\"12\" height=\"12\" fill=\"{}\"/></svg> "
        "{}</span>",
        chart_colour(part), escape(parts[part]));
  return html + "</p>\n";
}

}  // namespace dermis::cli::html
