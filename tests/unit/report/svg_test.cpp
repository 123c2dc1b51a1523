// SPDX-License-Identifier: MIT
// Where a value lies on an axis, and what the elements of a chart hold.
#include "tools/report/svg.h"

#include <gtest/gtest.h>

namespace dermis::report {
namespace {

TEST(Svg, AScaleMapsItsEndsToItsEnds) {
  const Scale linear{.from = 178, .to = 28, .low = -1, .high = 3};
  EXPECT_EQ(linear(-1), 178);
  EXPECT_EQ(linear(3), 28);
  EXPECT_EQ(linear(1), 103);
  EXPECT_EQ(linear(5), -47);
  EXPECT_EQ(linear.clamped(5), 28);
  EXPECT_EQ(linear.value_at(0.25), 0);

  const Scale decades{.from = 0, .to = 300, .low = 0.1, .high = 100, .logarithmic = true};
  EXPECT_NEAR(decades(0.1), 0, 1e-9);
  EXPECT_NEAR(decades(1), 100, 1e-9);
  EXPECT_NEAR(decades(100), 300, 1e-9);
  EXPECT_NEAR(decades.value_at(2.0 / 3), 10, 1e-9);
}

TEST(Svg, StepsOfAnAxis) {
  EXPECT_NEAR(tick_step(2.77, 6), 0.5, 1e-12);
  EXPECT_NEAR(tick_step(6, 6), 1, 1e-12);
  EXPECT_NEAR(tick_step(6.1, 6), 2, 1e-12);
  EXPECT_NEAR(tick_step(900, 4), 500, 1e-9);
  EXPECT_EQ(tick_step(0, 6), 1);
  for (double max = 0.01; max < 1e6; max *= 1.37) {
    const double step = tick_step(max, 6);
    EXPECT_GE(6 * step, max * (1 - 1e-6));
    EXPECT_LT(2 * step, max * 1.7) << "no coarser than it must be";
  }

  EXPECT_EQ(ticks(2, 4), (std::vector<double>{0, 0.5, 1, 1.5, 2}));
  EXPECT_EQ(ticks(0, 4), (std::vector<double>{0}));
  EXPECT_EQ(decades(0.5, 200), (std::vector<double>{1, 10, 100}));
  EXPECT_EQ(decades(1, 10), (std::vector<double>{1, 10}));
}

TEST(Svg, ElementsEscapeTheirWords) {
  EXPECT_EQ(text({1, 2}, "end", "a < b"), "<text x=\"1.0\" y=\"2.0\" text-anchor=\"end\">a &lt; b</text>");
  EXPECT_EQ(line({0, 1}, {2, 3.26}, "stroke=\"#999\""),
            "<line x1=\"0.0\" y1=\"1.0\" x2=\"2.0\" y2=\"3.3\" stroke=\"#999\"/>");
  EXPECT_EQ(polyline({{0, 1}, {2, 3}}, "stroke=\"#999\""),
            "<polyline fill=\"none\" stroke=\"#999\" points=\"0.0,1.0 2.0,3.0 \"/>");
}

}  // namespace
}  // namespace dermis::report
