// SPDX-License-Identifier: MIT
#include "environment/sources.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <numbers>

#include "environment/harmonics.h"

namespace dermis::environment {
namespace {

using std::numbers::pi;

struct Disc {
  glm::dvec3 towards;
  double half_angle_rad;
  glm::dvec3 radiance;
};

glm::dvec3 towards(double azimuth_deg, double elevation_deg) {
  return direction_of(0.5 + azimuth_deg / 360, 0.5 - elevation_deg / 180);
}

/// A blue gradient over a ground, and discs in it. Those too small for a pixel are the nearest one.
Environment sky(int width, int height, const std::vector<Disc>& discs) {
  Environment e{.name = "sky", .radiance = {.width = width, .height = height, .channels = 3, .values = {}}};
  for (int y = 0; y < height; ++y)
    for (int x = 0; x < width; ++x) {
      const glm::dvec3 d = direction_of((x + 0.5) / width, (y + 0.5) / height);
      glm::dvec3 rgb =
          d.y < 0 ? glm::dvec3(0.16, 0.13, 0.1) : glm::dvec3(0.7, 0.8, 1) - d.y * glm::dvec3(0.5, 0.4, 0.2);
      for (const Disc& disc : discs)
        if (glm::dot(d, disc.towards) > std::cos(disc.half_angle_rad)) rgb = disc.radiance;
      for (int c = 0; c < 3; ++c) e.radiance.values.push_back(static_cast<float>(rgb[c]));
    }
  for (const Disc& disc : discs) {
    const glm::dvec2 at = place_of(disc.towards);
    float* rgb = e.radiance.at(std::min(static_cast<int>(at.x * width), width - 1),
                               std::min(static_cast<int>(at.y * height), height - 1));
    for (int c = 0; c < 3; ++c) rgb[c] = static_cast<float>(disc.radiance[c]);
  }
  return e;
}

/// Int radiance dOmega, as it is read.
glm::dvec3 energy(const image::ImageF& picture) {
  glm::dvec3 sum(0);
  for (int y = 0; y < picture.height; ++y)
    for (int x = 0; x < picture.width; ++x) {
      const float* rgb = picture.at(x, y);
      sum += glm::dvec3(rgb[0], rgb[1], rgb[2]) * pixel_solid_angle(y, picture.width, picture.height);
    }
  return sum;
}

void expect_same_energy(const Environment& picture, const Split& split) {
  const glm::dvec3 before = energy(picture.radiance);
  glm::dvec3 after = energy(split.remainder.radiance);
  for (const Source& source : split.sources) after += source.irradiance;
  for (int c = 0; c < 3; ++c) EXPECT_NEAR(after[c], before[c], 1e-5 * before[c]) << c;
  for (std::size_t i = 0; i < picture.radiance.values.size(); ++i) {
    ASSERT_GE(split.remainder.radiance.values[i], 0);
    ASSERT_LE(split.remainder.radiance.values[i], picture.radiance.values[i]);
  }
}

constexpr glm::dvec3 sunlight{110000, 102000, 90000};

TEST(PixelSolidAngle, IsThatOfBilinearReading) {
  for (const auto& [width, height] : {std::pair(1, 1), {2, 1}, {4, 2}, {7, 5}, {64, 32}}) {
    double all = 0;
    for (int row = 0; row < height; ++row) all += width * pixel_solid_angle(row, width, height);
    EXPECT_NEAR(all, 4 * pi, 1e-12);
  }
  for (const int row : {0, 1, 4}) {
    image::ImageF picture{.width = 16, .height = 8, .channels = 3, .values = std::vector<float>(384)};
    picture.at(5, row)[1] = 1;
    double sum = 0;
    constexpr int rows = 800;
    for (int y = 0; y < rows; ++y)
      for (int x = 0; x < 2 * rows; ++x)
        sum += radiance_at(picture, {(x + 0.5) / (2 * rows), (y + 0.5) / rows}).y *
               std::sin(pi * (y + 0.5) / rows) * pi * pi / (rows * rows);
    EXPECT_NEAR(sum, pixel_solid_angle(row, 16, 8), 2e-4 * sum) << row;
  }
}

TEST(Sources, ASmoothPictureHasNone) {
  Environment grey = sky(64, 32, {});
  std::fill(grey.radiance.values.begin(), grey.radiance.values.end(), 0.7f);
  Environment black = grey;
  std::fill(black.radiance.values.begin(), black.radiance.values.end(), 0.0f);
  Environment noisy = sky(256, 128, {});
  for (std::size_t i = 0; i < noisy.radiance.values.size(); ++i)
    noisy.radiance.values[i] *= 1 + 0.2f * static_cast<float>(i * 2654435761u % 1000) / 1000;
  for (const Environment& e :
       {grey, black, noisy, sky(256, 128, {}), sky(1, 1, {}), sky(2, 1, {}), sky(7, 5, {})}) {
    const Split split = split_sources(e);
    EXPECT_TRUE(split.sources.empty()) << e.radiance.width;
    EXPECT_EQ(split.remainder.radiance.values, e.radiance.values);
  }
}

// Anywhere, over the seam and at the poles as well, from a pixel to as wide as a hand at arm's length.
TEST(Sources, ASunIsFound) {
  for (const glm::dvec3& where : {towards(20, 35), towards(180, 10), towards(179.9, 60), towards(-100, -30),
                                  towards(0, 89.9), towards(50, -89.9), towards(-60, 80)})
    for (const double half_angle_rad : {0.0, 0.0047, 0.012, 0.1, 0.3}) {
      const double most = half_angle_rad > 0.05 ? 0.01 : 1;
      const Environment e = sky(256, 128, {{where, half_angle_rad, most * sunlight}});
      const Split split = split_sources(e);
      SCOPED_TRACE(testing::Message() << where.x << " " << where.y << " " << half_angle_rad);
      expect_same_energy(e, split);
      ASSERT_EQ(split.sources.size(), 1u);
      const Source& sun = split.sources.front();

      // Within half a pixel; as wide as the disc, blurred by reading.
      EXPECT_GT(glm::dot(sun.direction, where), std::cos(0.02));
      EXPECT_GT(sun.tangent, 0.9 * half_angle_rad);
      EXPECT_LT(sun.tangent, std::tan(half_angle_rad) * 1.1 + 0.03);

      // What is left of it is not brighter than the sky on average.
      double brightest = 0;
      for (const float value : split.remainder.radiance.values)
        brightest = std::max(brightest, double{value});
      EXPECT_LT(brightest, 1 + energy(e.radiance).x / (4 * pi));
    }
}

TEST(Sources, ALargePictureIsMadeSmaller) {
  const Environment e = sky(4096, 64, {{towards(20, 35), 0, sunlight}});
  const Split split = split_sources(e);
  EXPECT_EQ(split.remainder.radiance.width, 2048);
  ASSERT_EQ(split.sources.size(), 1u);
  EXPECT_GT(glm::dot(split.sources.front().direction, towards(20, 35)), std::cos(0.05));
  const glm::dvec3 before = energy(e.radiance),
                   after = energy(split.remainder.radiance) + split.sources.front().irradiance;
  for (int c = 0; c < 3; ++c) EXPECT_NEAR(after[c], before[c], 1e-5 * before[c]);
}

// Blue sky around a red sun: no channel falls below what was there.
TEST(Sources, ColoursStay) {
  const Environment e = sky(256, 128, {{towards(30, 5), 0.03, {5000, 200, 0.2}}});
  const Split split = split_sources(e);
  ASSERT_EQ(split.sources.size(), 1u);
  expect_same_energy(e, split);
  EXPECT_EQ(split.sources.front().irradiance.z, 0);
  EXPECT_NEAR(split.sources.front().irradiance.x / split.sources.front().irradiance.y, 25, 0.3);
}

TEST(Sources, ASunInItsGlareStaysSharp) {
  const glm::dvec3 where = towards(30, 40);
  Environment e = sky(512, 256, {{where, 0.01, 0.5 * sunlight}});
  for (int y = 0; y < 256; ++y)
    for (int x = 0; x < 512; ++x) {
      const double angle =
          std::acos(std::min(glm::dot(direction_of((x + 0.5) / 512, (y + 0.5) / 256), where), 1.0));
      for (int c = 0; c < 3; ++c)
        e.radiance.at(x, y)[c] += 300.0f * static_cast<float>(std::exp(-angle * angle / 0.005));
    }
  const Split split = split_sources(e);
  expect_same_energy(e, split);
  ASSERT_GE(split.sources.size(), 2u) << "the sun and its glare, in one ring or two";
  ASSERT_LE(split.sources.size(), 3u);
  EXPECT_LT(split.sources[0].tangent, 0.02) << "the sun is not as wide as its glare";
  for (const Source& source : split.sources) EXPECT_GT(glm::dot(source.direction, where), std::cos(0.01));
}

TEST(Sources, AStripIsARowOfDiscs) {
  Environment e = sky(512, 256, {});
  for (float& value : e.radiance.values) value *= 0.1f;
  for (int y = 120; y < 125; ++y)
    for (int x = 200; x < 260; ++x)
      for (int c = 0; c < 3; ++c) e.radiance.at(x, y)[c] = 200;
  const Split split = split_sources(e);
  expect_same_energy(e, split);
  ASSERT_EQ(split.sources.size(), 4u);
  for (const Source& source : split.sources)
    EXPECT_NEAR(source.irradiance.x, split.sources.front().irradiance.x, 0.1 * source.irradiance.x);
}

TEST(Sources, TheWeakestOfManyStay) {
  std::vector<Disc> bulbs;
  for (int i = 0; i < 12; ++i) bulbs.push_back({towards(30 * i, 20), 0.02, glm::dvec3(1000 + 50 * i)});
  const Environment e = sky(512, 256, bulbs);
  const Split split = split_sources(e);
  expect_same_energy(e, split);
  ASSERT_EQ(split.sources.size(), most_sources);
  for (std::size_t i = 1; i < most_sources; ++i)
    EXPECT_GE(split.sources[i - 1].irradiance.x, split.sources[i].irradiance.x);
  EXPECT_GT(glm::dot(split.sources.front().direction, bulbs.back().towards), 0.999);
}

// Occluders reflect the light of a source by the series up to order 3, which is near the cosine for all of
// them. A window that takes the values below 0 out of it would leave 0.58 where it faces the source.
TEST(WithSources, OccludersGetTheLightOfASource) {
  const SkyHarmonics lit =
      with_sources(SkyHarmonics{}, std::array{Source{.direction = towards(40, 65), .irradiance = sunlight}});
  double total = 0;
  for (int i = 0; i < 1000; ++i) {
    const double y = 1 - (2 * i + 1) / 1000.0, across = std::sqrt(1 - y * y);
    const glm::dvec3 n(across * std::cos(2.4 * i), y, across * std::sin(2.4 * i));
    const double share = irradiance_of(lit, n, 3).x / sunlight.x;
    EXPECT_NEAR(share, std::max(glm::dot(n, towards(40, 65)), 0.0), 0.1);
    total += share / 1000;
  }
  EXPECT_NEAR(total, 0.25, 0.001) << "that of a sphere";
}

TEST(WithoutRinging, IsNowhereBelowZeroAndKeepsTheMean) {
  const Environment sun = sky(128, 64, {{towards(40, 20), 0.0, 1000.0 * sunlight}});
  const SkyHarmonics rings = sky_of(sun.radiance), still = without_ringing(rings);
  EXPECT_EQ(still[0], rings[0]);

  // Find the least irradiance over 1000 directions spread evenly.
  double least = 1e30, least_before = 1e30;
  for (int i = 0; i < 1000; ++i) {
    const double y = 1 - (2 * i + 1) / 1000.0, across = std::sqrt(1 - y * y);
    const glm::dvec3 n(across * std::cos(2.4 * i), y, across * std::sin(2.4 * i));
    least = std::min(least, irradiance_of(still, n).x / rings[0].x);
    least_before = std::min(least_before, irradiance_of(rings, n).x / rings[0].x);
  }

  EXPECT_LT(least_before, -0.02);
  EXPECT_GT(least, -1e-3);
  EXPECT_LT(least, 0.02) << "no more than it takes";

  const SkyHarmonics calm = sky_of(studio().radiance);
  EXPECT_EQ(without_ringing(calm), calm);
}

}  // namespace
}  // namespace dermis::environment
