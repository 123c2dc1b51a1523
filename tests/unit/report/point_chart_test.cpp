// SPDX-License-Identifier: MIT
#include "tools/report/point_chart.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <string>

namespace dermis::report {
namespace {

int count_of(const std::string& text, const std::string& what) {
  int found = 0;
  for (std::size_t at = text.find(what); at != std::string::npos; at = text.find(what, at + 1)) ++found;
  return found;
}

PointChart two_curves() {
  return {.title = "error <over> cost",
          .x_name = "ms",
          .y_name = "relMSE",
          .curves = {{"a", {{2, 1e-3, "few"}, {40, 2e-5, "many"}}}, {"b", {{5, 1e-4, "only"}}}}};
}

TEST(PointChart, HasADotPerPointAndALineOfCurves) {
  const std::string svg = point_chart(two_curves());
  EXPECT_EQ(count_of(svg, "<circle"), 3);
  EXPECT_EQ(count_of(svg, "<polyline"), 1) << "a single point has no line";
  EXPECT_NE(svg.find("a, many: 40, 2e-05"), std::string::npos) << svg;
  EXPECT_EQ(svg.find("<over>"), std::string::npos);
  // Whole decades of both axes.
  for (const char* tick : {">1<", ">10<", ">100<", ">0.001<", ">1e-05<"})
    EXPECT_NE(svg.find(tick), std::string::npos) << tick;
}

TEST(PointChart, LeavesOutWhatALogarithmHasNot) {
  PointChart chart = two_curves();
  chart.curves[0].points.push_back({0, 1e-3, "no time"});
  chart.curves[0].points.push_back({1, -1e-3, "below the noise"});
  chart.curves[0].points.push_back({1, std::numeric_limits<double>::quiet_NaN(), "none"});
  EXPECT_EQ(count_of(point_chart(chart), "<circle"), 3);
  EXPECT_EQ(point_chart({.title = "", .x_name = "", .y_name = "", .curves = {{"a", {{0, 1, ""}}}}}), "");
}

TEST(PointChart, OnePointHasAnExtent) {
  const std::string svg =
      point_chart({.title = "t", .x_name = "x", .y_name = "y", .curves = {{"a", {{10, 10, "p"}}}}});
  EXPECT_EQ(count_of(svg, "<circle"), 1);
  EXPECT_EQ(svg.find("nan"), std::string::npos);
  EXPECT_EQ(svg.find("inf"), std::string::npos);
}

}  // namespace
}  // namespace dermis::report
