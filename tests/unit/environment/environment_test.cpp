// SPDX-License-Identifier: MIT
#include "environment/environment.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <fstream>
#include <limits>
#include <numbers>

#include "base/core/error.h"
#include "image/codec.h"

namespace dermis::environment {
namespace {

using std::numbers::pi;

Environment painted(int width, int height, const std::function<glm::dvec3(const glm::dvec3&)>& radiance) {
  Environment e{.name = "painted",
                .radiance = {.width = width, .height = height, .channels = 3, .values = {}}};
  for (int y = 0; y < height; ++y)
    for (int x = 0; x < width; ++x) {
      const glm::dvec3 rgb = radiance(direction_of((x + 0.5) / width, (y + 0.5) / height));
      for (int c = 0; c < 3; ++c) e.radiance.values.push_back(static_cast<float>(rgb[c]));
    }
  return e;
}

std::vector<glm::dvec3> some_directions() {
  std::vector<glm::dvec3> all;
  for (int i = 0; i < 50; ++i) {
    const double z = 1 - (2 * i + 1) / 50.0, a = 2.4 * i;
    all.emplace_back(std::sqrt(1 - z * z) * std::cos(a), std::sqrt(1 - z * z) * std::sin(a), z);
  }
  return all;
}

TEST(Directions, PlaceIsTheInverse) {
  for (const glm::dvec3& d : some_directions()) {
    const glm::dvec2 at = place_of(d);
    EXPECT_LT(glm::length(direction_of(at.x, at.y) - d), 1e-12);
  }
  EXPECT_LT(glm::length(direction_of(0.5, 0.5) - glm::dvec3(0, 0, -1)), 1e-12)
      << "the middle lies behind the head";
  EXPECT_LT(glm::length(direction_of(0.75, 0.5) - glm::dvec3(1, 0, 0)), 1e-12);
  EXPECT_LT(glm::length(direction_of(0.3, 0) - glm::dvec3(0, 1, 0)), 1e-12);
}

TEST(Irradiance, OfAUniformSurroundingIsPi) {
  for (const auto& [width, height] : {std::pair(1, 1), {64, 32}, {7, 5}, {2, 1}}) {
    const Irradiance e =
        irradiance_of(painted(width, height, [](const glm::dvec3&) { return glm::dvec3(1, 2, 0.5); }));
    for (const glm::dvec3& n : some_directions())
      EXPECT_LT(glm::length(evaluate(e, n) - pi * glm::dvec3(1, 2, 0.5)), 0.02 * pi)
          << width << "x" << height;
  }
}

// Against the integral itself, for a sky that order 2 can hold, and for the studio, which it cannot quite.
TEST(Irradiance, IsTheCosineIntegral) {
  const auto error = [](const Environment& environment) {
    const Irradiance e = irradiance_of(environment);
    double worst = 0, mean = 0;
    const image::ImageF& p = environment.radiance;

    for (const glm::dvec3& n : some_directions()) {
      // Sum the green radiance times the cosine over the solid angles of all texels.
      double exact = 0;
      for (int y = 0; y < p.height; ++y)
        for (int x = 0; x < p.width; ++x) {
          const glm::dvec3 d = direction_of((x + 0.5) / p.width, (y + 0.5) / p.height);
          exact += std::max(glm::dot(d, n), 0.0) * p.at(x, y)[1] * std::sin(pi * (y + 0.5) / p.height) * 2 *
                   pi * pi / (p.width * p.height);
        }

      worst = std::max(worst, std::abs(evaluate(e, n).y - exact));
      mean += exact / 50;
    }

    return worst / mean;
  };
  EXPECT_LT(error(painted(
                128, 64,
                [](const glm::dvec3& d) { return glm::dvec3(1 + 0.6 * d.y + 0.3 * d.x * d.z + 0.2 * d.x); })),
            0.005);
  EXPECT_LT(error(studio()), 0.12);
}

TEST(Prefilter, WhiteStaysWhite) {
  const std::vector<image::ImageF> levels =
      prefilter(painted(32, 16, [](const glm::dvec3&) { return glm::dvec3(0.7, 1, 3); }));
  ASSERT_EQ(levels.size(), static_cast<std::size_t>(prefilter_levels));
  for (std::size_t k = 0; k < levels.size(); ++k) {
    EXPECT_EQ(levels[k].width, prefilter_width >> k);
    for (int i = 0; i < levels[k].width * levels[k].height; ++i) {
      EXPECT_NEAR(levels[k].values[3 * static_cast<std::size_t>(i)], 0.7, 1e-5);
      EXPECT_NEAR(levels[k].values[3 * static_cast<std::size_t>(i) + 2], 3, 1e-5);
    }
  }
}

// A small lamp: each level keeps its light, spreads it further, and stays centred on it.
TEST(Prefilter, SpreadsALamp) {
  const glm::dvec3 lamp = glm::normalize(glm::dvec3(0.3, 0.2, -1));
  const std::vector<image::ImageF> levels = prefilter(painted(512, 256, [&](const glm::dvec3& d) {
    return glm::dvec3(glm::dot(d, lamp) > std::cos(0.05) ? 100 : 0.1);
  }));

  double last_peak = 1e9, first_sum = 0;
  for (std::size_t k = 0; k < levels.size(); ++k) {
    double sum = 0, peak = 0;
    glm::dvec3 middle(0);

    // Sum the level's light, its direction without the surroundings' 0.1, and its peak.
    for (int y = 0; y < levels[k].height; ++y)
      for (int x = 0; x < levels[k].width; ++x) {
        const double v = (y + 0.5) / levels[k].height, value = levels[k].at(x, y)[0];
        const glm::dvec3 d = direction_of((x + 0.5) / levels[k].width, v);
        const double sr = std::sin(pi * v) * 2 * pi * pi / (levels[k].width * levels[k].height);
        sum += value * sr;
        middle += d * ((value - 0.1) * sr);
        peak = std::max(peak, value);
      }

    if (k == 0) first_sum = sum;
    EXPECT_NEAR(sum, first_sum, 0.15 * first_sum) << k;
    EXPECT_LT(peak, last_peak) << k;
    EXPECT_GT(glm::dot(glm::normalize(middle), lamp), 0.99) << k;
    last_peak = peak;
  }
}

TEST(Studio, IsBrightEnoughAndNotBlackAnywhere) {
  const Environment e = studio();
  const double mean = irradiance_of(e)[0].y / pi;
  EXPECT_GT(mean, 0.5);
  EXPECT_LT(mean, 0.6);
  for (const float value : e.radiance.values) EXPECT_GT(value, 0.01f);
}

class Files : public testing::Test {
 protected:
  std::string file(const std::string& name, const std::string& bytes) const {
    const std::string path = testing::TempDir() + "dermis_environment_" + name;
    std::ofstream(path, std::ios::binary) << bytes;
    return path;
  }
  static void expect_refused(const std::string& path, const std::string& says) {
    try {
      from_name_or_file(path);
      ADD_FAILURE() << path << " was read";
    } catch (const InputError& error) {
      EXPECT_NE(std::string(error.what()).find(says), std::string::npos) << error.what();
    }
  }
};

TEST_F(Files, HostileOnesAreRefusedOrMended) {
  expect_refused("no/such/file.hdr", "studio");
  expect_refused("", "studio");
  expect_refused(testing::TempDir(), "");
  expect_refused(file("empty.hdr", ""), "");
  expect_refused(file("header.hdr", "#?RADIENCE\nnonsense"), "");
  expect_refused(file("text.exr", "not a picture"), "");
  expect_refused(file("wide.hdr", "#?RADIANCE\nFORMAT=32-bit_rle_rgbe\n\n-Y 15000 +X 30000\n"), "");
  expect_refused(
      file("cut.hdr", "#?RADIANCE\nFORMAT=32-bit_rle_rgbe\n\n-Y 512 +X 1024\n" + std::string(100, '\2')), "");
}

TEST_F(Files, PixelsThatAreNoNumbersAreMended) {
  const std::string path = testing::TempDir() + "dermis_environment_nan.exr";
  image::ImageF picture{.width = 4, .height = 2, .channels = 3, .values = std::vector<float>(24, 1.0f)};
  picture.values[0] = std::numeric_limits<float>::quiet_NaN();
  picture.values[4] = std::numeric_limits<float>::infinity();
  picture.values[8] = -3;
  image::save_exr(path, picture);
  const Environment e = load(path);
  for (const float value : e.radiance.values) EXPECT_TRUE(value >= 0 && value <= 65504) << value;
  EXPECT_EQ(std::ranges::max(e.radiance.values), 65504) << "infinite light is the brightest";
  for (const glm::dvec3& n : some_directions()) EXPECT_TRUE(std::isfinite(evaluate(irradiance_of(e), n).x));
  for (const image::ImageF& level : prefilter(e))
    for (const float value : level.values) ASSERT_TRUE(std::isfinite(value));
}

TEST_F(Files, OnePixelIsAUniformSurrounding) {
  const std::string path = testing::TempDir() + "dermis_environment_one.exr";
  image::save_exr(path, {.width = 1, .height = 1, .channels = 3, .values = {0.5f, 0.25f, 0.125f}});
  const Irradiance e = irradiance_of(load(path));
  for (const glm::dvec3& n : some_directions())
    EXPECT_LT(glm::length(evaluate(e, n) - pi * glm::dvec3(0.5, 0.25, 0.125)), 1e-3);
}

}  // namespace
}  // namespace dermis::environment
