// SPDX-License-Identifier: MIT
#include "tools/report/charts.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <numeric>

#include "tools/report/escape.h"
#include "tools/report/svg.h"

namespace dermis::report {
namespace {

// Okabe, Ito: Color Universal Design, 2008; without black, with a grey.
constexpr std::array colours{"#56b4e9", "#e69f00", "#009e73", "#f0e442",
                             "#cc79a7", "#d55e00", "#8f8fff", "#999999"};

// Of a line chart, in units that are pixels where there is room.
constexpr double width = 330, height = 220, left = 38, right = 318, top = 28, bottom = 178;

/// Positions of the values; those of x lie in the middle of their share of the width.
Scale y_scale(const LineChart& chart) { return {.from = bottom, .to = top, .low = 0, .high = chart.y_max}; }
double x_of(const LineChart& chart, std::size_t i) {
  const Scale scale{.from = left, .to = right, .low = 0, .high = static_cast<double>(chart.x.size())};
  return scale(static_cast<double>(i) + 0.5);
}

std::string axes(const LineChart& chart) {
  std::string svg = text({left, 14}, "start", chart.title, "class=\"title\"") +
                    text({(left + right) / 2, height - 6}, "middle", chart.x_name);
  for (const double value : ticks(chart.y_max, 6)) {
    const double y = y_scale(chart)(value);
    svg += line({left, y}, {right, y}, "class=\"grid\"") + text({left - 6, y + 4}, "end", number(value));
  }
  for (std::size_t i = 0; i < chart.x.size(); ++i)
    svg += text({x_of(chart, i), bottom + 16}, "middle", chart.x[i]);
  return svg;
}

/// Colour and dashes of a line, in the chart and in its legend.
std::string stroke(const Line& line) {
  return fmt::format("stroke=\"{}\" stroke-width=\"2\"{}", chart_colour(line.colour),
                     line.dashed ? " stroke-dasharray=\"5 4\"" : "");
}

std::string drawn(const LineChart& chart, const Line& line) {
  std::string svg, dots;
  std::vector<Point> points;
  // Close the line that has been drawn so far: a missing value leaves a gap.
  const auto end = [&] {
    if (!points.empty()) svg += polyline(points, stroke(line));
    points.clear();
  };

  for (std::size_t i = 0; i < std::min(line.values.size(), chart.x.size()); ++i) {
    const std::optional<double> value = line.values[i];
    if (!value || !std::isfinite(*value)) {
      end();
      continue;
    }

    points.push_back({x_of(chart, i), y_scale(chart).clamped(*value)});
    dots += fmt::format(
        "<circle cx=\"{:.1f}\" cy=\"{:.1f}\" r=\"3\" fill=\"{}\"><title>{}, {}: {}</title></circle>",
        points.back().x, points.back().y, chart_colour(line.colour), escape(line.name), escape(chart.x[i]),
        number(*value));
  }

  end();
  return svg + dots;
}

}  // namespace

const char* chart_colour(std::size_t number) { return colours[number % colours.size()]; }

std::string line_chart(const LineChart& chart) {
  std::string svg =
      fmt::format("<svg class=\"chart\" viewBox=\"0 0 {} {}\" width=\"{}\" role=\"img\" aria-label=\"{}\">",
                  width, height, width, escape(chart.title)) +
      axes(chart);
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
    svg += text({name_end, y + 15}, "end", bar.name);
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

    svg += text({x + 6, y + 15}, "start",
                fmt::format("{} {}", sum >= 100 ? fmt::format("{:.0f}", sum) : number(sum), chart.unit));
    y += row;
  }
  return svg + "</svg>\n";
}

std::string legend(const std::vector<Line>& lines) {
  std::string html = "<p class=\"legend\">";
  for (const Line& entry : lines)
    html += "<span><svg width=\"26\" height=\"10\">" + line({0, 5}, {26, 5}, stroke(entry)) + "</svg> " +
            escape(entry.name) + "</span>";
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

}  // namespace dermis::report
