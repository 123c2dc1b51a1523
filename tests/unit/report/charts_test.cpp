// SPDX-License-Identifier: MIT
#include "tools/report/charts.h"

#include <gtest/gtest.h>

#include <string_view>

namespace dermis::report {
namespace {

std::size_t count(const std::string& text, std::string_view part) {
  std::size_t found = 0;
  for (std::size_t at = text.find(part); at != std::string::npos; at = text.find(part, at + 1)) ++found;
  return found;
}

TEST(Charts, ALineHasGapsWhereThereIsNothing) {
  const LineChart chart{
      .title = "a < b",
      .x_name = "heads",
      .x = {"1", "2", "4", "8"},
      .lines = {{"ours", 0, false, {1.0, 2.0, std::nullopt, 1.5}}, {"theirs", 1, true, {1.0, 1.0, 1.0, 1.0}}},
      .y_max = 2};
  const std::string svg = line_chart(chart);
  EXPECT_EQ(count(svg, "<polyline"), 3u);
  EXPECT_EQ(count(svg, "<circle"), 7u);
  EXPECT_EQ(count(svg, "stroke-dasharray"), 1u);
  EXPECT_EQ(count(svg, "a &lt; b"), 2u) << "drawn, and said to those who do not see it";
  EXPECT_NE(svg.find("ours, 2: 2"), std::string::npos);
  // The greatest value touches the top of the axes, 0 would touch the bottom.
  EXPECT_NE(svg.find("cy=\"28.0\""), std::string::npos);
  EXPECT_NE(svg.find("cy=\"103.0\""), std::string::npos);
}

TEST(Charts, BarsShareAScale) {
  const BarChart chart{.unit = "ms", .parts = {"a", "b"}, .bars = {{"all", {30, 10}}, {"half", {20, 0}}}};
  const std::string svg = bar_chart(chart);
  EXPECT_EQ(count(svg, "<rect"), 3u) << "nothing is not drawn";
  EXPECT_NE(svg.find("width=\"420.00\""), std::string::npos);
  EXPECT_NE(svg.find("width=\"140.00\""), std::string::npos);
  EXPECT_NE(svg.find("width=\"280.00\""), std::string::npos);
  EXPECT_NE(svg.find("40 ms"), std::string::npos);
  const std::string nothing = bar_chart({.unit = "ms", .parts = {"a"}, .bars = {{"none", {0}}}});
  EXPECT_EQ(count(nothing, "nan") + count(nothing, "inf"), 0u);
}

TEST(Charts, Legends) {
  EXPECT_EQ(count(legend(std::vector<std::string>{"a&b", "c"}), "<rect"), 2u);
  EXPECT_NE(legend(std::vector<std::string>{"a&b"}).find("a&amp;b"), std::string::npos);
  EXPECT_EQ(count(legend(std::vector<Line>{{"x", 0, true, {}}, {"y", 1, false, {}}}), "stroke-dasharray"),
            1u);
}

}  // namespace
}  // namespace dermis::report
