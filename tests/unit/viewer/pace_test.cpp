// SPDX-License-Identifier: MIT
#include "viewer/model/pace.h"

#include <gtest/gtest.h>

namespace dermis::viewer {
namespace {

// What a picture takes on a device: by its pixels, and something of its own.
double ms_on(double ms_of_full, int divisor) { return 5 + ms_of_full / (divisor * divisor); }

TEST(Pace, ASlowDeviceDrawsSmaller) {
  Pace pace;
  for (int i = 0; i < 40; ++i) pace.drew(ms_on(2000, pace.divisor()));
  EXPECT_LE(ms_on(2000, pace.divisor()), pace_ms);
  const int there = pace.divisor();
  for (int i = 0; i < 40; ++i) {
    pace.drew(ms_on(2000, pace.divisor()));
    EXPECT_EQ(pace.divisor(), there) << "back and forth makes a plan each time";
  }
}

TEST(Pace, AFastDeviceDrawsTheWholePicture) {
  Pace pace;
  for (int i = 0; i < 60; ++i) pace.drew(2);
  EXPECT_EQ(pace.divisor(), 1);
}

TEST(Pace, WhatNothingIsFastEnoughForStaysAtTheSmallest) {
  Pace pace;
  for (int i = 0; i < 60; ++i) pace.drew(5000);
  EXPECT_EQ(pace.divisor(), Pace::divisors.back());
}

TEST(Pace, ASmallerPictureHasSmallerMaps) {
  Pace pace;
  RenderSettings full;
  full.output.width = 1200;
  full.output.height = 7;
  const RenderSettings small = pace.settings(full);
  EXPECT_EQ(small.output.width, 1200 / pace.divisor());
  EXPECT_GE(small.output.height, 1);
  EXPECT_LT(small.quality.map_size, full.quality.map_size);
  EXPECT_EQ(small.quality.samples, 1);

  // Never larger than what was asked for.
  full.quality.map_size = full.quality.shadow_size = 64;
  EXPECT_EQ(pace.settings(full).quality.map_size, 64);
  EXPECT_EQ(pace.settings(full).quality.shadow_size, 64);
}

}  // namespace
}  // namespace dermis::viewer
