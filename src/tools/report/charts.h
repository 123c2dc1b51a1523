// SPDX-License-Identifier: MIT
// Charts for pages: SVG within the document, no script.
#pragma once

#include <optional>
#include <string>
#include <vector>

namespace dermis::report {

/// Colours that stay apart on the dark page and for colour-blind eyes; number is taken modulo their count.
const char* chart_colour(std::size_t number);

struct Line {
  std::string name;
  std::size_t colour = 0;  ///< of chart_colour()
  bool dashed = false;
  std::vector<std::optional<double>> values;  ///< one for each x; the line has a gap where there is none
};

struct LineChart {
  std::string title, x_name;
  std::vector<std::string> x;  ///< evenly spaced
  std::vector<Line> lines;
  double y_max = 1;  ///< of the axis, which begins at 0; charts that stand side by side share it
};
/// An svg element. Every point names its value when pointed at.
std::string line_chart(const LineChart& chart);

struct Bar {
  std::string name;
  std::vector<double> parts;  ///< >= 0, one for each part name
};

struct BarChart {
  std::string unit;
  std::vector<std::string> parts;  ///< names; their place is their colour
  std::vector<Bar> bars;
};
/// An svg element: a row for each bar, its parts stacked from the left, its sum at the end; bars of one chart
/// share a scale.
std::string bar_chart(const BarChart& chart);

/// A row of coloured squares (or dashes, for lines) with their names.
std::string legend(const std::vector<Line>& lines);
std::string legend(const std::vector<std::string>& parts);

}  // namespace dermis::report
