// SPDX-License-Identifier: MIT
#include "cli/charts.h"

#include <gtest/gtest.h>

#include <string_view>

namespace dermis::cli {
namespace {

std::size_t count(const std::string& text, std::string_view part) {
  std::size_t found = 0;
  for (std::size_t at = text.find(part); at != std::string::npos; at = text.find(part, at + 1)) ++found;
  return found;
}

TEST(Charts, StepsOfAnAxis) {
  EXPECT_NEAR(html::tick_step(2.77, 6), 0.5, 1e-12);
  EXPECT_NEAR(html::tick_step(6, 6), 1, 1e-12);
  EXPECT_NEAR(html::tick_step(6.1, 6), 2, 1e-12);
  EXPECT_NEAR(html::tick_step(900, 4), 500, 1e-9);
  EXPECT_EQ(html::tick_step(0, 6), 1);
  for (double max = 0.01; max < 1e6; max *= 1.37) {
    const double step = html::tick_step(max, 6);
    EXPECT_GE(6 * step, max * (1 - 1e-6));
    EXPECT_LT(2 * step, max * 1.7) << "no coarser than it must be";
  }
}

TEST(Charts, ALineHasGapsWhereThereIsNothing) {
  const html::LineChart chart{
      .title = "a < b",
      .x_name = "heads",
      .x = {"1", "2", "4", "8"},
      .lines = {{"ours", 0, false, {1.0, 2.0, std::nullopt, 1.5}}, {"theirs", 1, true, {1.0, 1.0, 1.0, 1.0}}},
      .y_max = 2};
  const std::string svg = html::line_chart(chart);
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
  const html::BarChart chart{
      .unit = "ms", .parts = {"a", "b"}, .bars = {{"all", {30, 10}}, {"half", {20, 0}}}};
  const std::string svg = html::bar_chart(chart);
  EXPECT_EQ(count(svg, "<rect"), 3u) << "nothing is not drawn";
  EXPECT_NE(svg.find("width=\"420.00\""), std::string::npos);
  EXPECT_NE(svg.find("width=\"140.00\""), std::string::npos);
  EXPECT_NE(svg.find("width=\"280.00\""), std::string::npos);
  EXPECT_NE(svg.find("40 ms"), std::string::npos);
  const std::string nothing = html::bar_chart({.unit = "ms", .parts = {"a"}, .bars = {{"none", {0}}}});
  EXPECT_EQ(count(nothing, "nan") + count(nothing, "inf"), 0u);
}

TEST(Charts, Legends) {
  EXPECT_EQ(count(html::legend(std::vector<std::string>{"a&b", "c"}), "<rect"), 2u);
  EXPECT_NE(html::legend(std::vector<std::string>{"a&b"}).find("a&amp;b"), std::string::npos);
  EXPECT_EQ(count(html::legend(std::vector<html::Line>{{"x", 0, true, {}}, {"y", 1, false, {}}}),
                  "stroke-dasharray"),
            1u);
}

}  // namespace
}  // namespace dermis::cli
