// SPDX-License-Identifier: MIT
#include <gtest/gtest.h>

#include <cmath>
#include <filesystem>
#include <limits>

#include "base/core/error.h"
#include "image/codec.h"
#include "image/compare_flip.h"
#include "pictures.h"
#include "support/assets.h"

namespace dermis::image {
namespace {

namespace fs = std::filesystem;

/// The pictures and values of the authors' implementation; empty if they are not at hand.
fs::path truth() {
  const fs::path folder = tests::asset_cache() / ".." / "truth" / "flip";
  return fs::exists(folder) ? folder : fs::path();
}

Image8 flat(int width, int height, std::uint8_t r, std::uint8_t g, std::uint8_t b) {
  Image8 picture{.width = width, .height = height, .rgba = {}};
  for (int i = 0; i < width * height; ++i)
    picture.rgba.insert(picture.rgba.end(), {r, g, b, std::uint8_t{255}});
  return picture;
}

Image8 noisy(int width, int height, std::uint32_t seed) {
  return {.width = width,
          .height = height,
          .rgba = test::noise(static_cast<std::size_t>(width * height * 4), seed)};
}

ImageF flat_f(int width, int height, float value) {
  return {.width = width,
          .height = height,
          .channels = 3,
          .values = std::vector<float>(static_cast<std::size_t>(width * height * 3), value)};
}

void expect_near(const FlipSummary& got, const FlipSummary& expected, double tolerance) {
  EXPECT_NEAR(got.mean, expected.mean, tolerance);
  EXPECT_NEAR(got.weighted_median, expected.weighted_median, tolerance);
  EXPECT_NEAR(got.q1, expected.q1, tolerance);
  EXPECT_NEAR(got.q3, expected.q3, tolerance);
  EXPECT_NEAR(got.min, expected.min, tolerance);
  EXPECT_NEAR(got.max, expected.max, tolerance);
}

class PublishedFlip : public testing::Test {
 protected:
  void SetUp() override {
    if (truth().empty()) GTEST_SKIP() << "the pictures to reproduce are not there";
  }
};

// Printed with six digits; float sums differ in the sixth.
constexpr double tolerance = 2e-5;

TEST_F(PublishedFlip, DisplayPictures) {
  const Image8 reference = load_image8(truth() / "ref.png");
  const auto summary = [&](const char* name) {
    return summarise_flip(flip_map(reference, load_image8(truth() / name)));
  };
  expect_near(summary("blur.png"), {0.048311, 0.057225, 0.038470, 0.085896, 0.001599, 0.362398}, tolerance);
  expect_near(summary("hue.png"), {0.243250, 0.246036, 0.229727, 0.259853, 0.118533, 0.348938}, tolerance);
  expect_near(summary("noise.png"), {0.078765, 0.086081, 0.067708, 0.107301, 0.004621, 0.288984}, tolerance);
  expect_near(summary("ref.png"), {0, 0, 0, 0, 0, 0}, 0);
}

TEST_F(PublishedFlip, EveryPixelOfAMap) {
  const ImageF map = flip_map(load_image8(truth() / "ref.png"), load_image8(truth() / "blur.png"));
  const Image8 expected = load_image8(truth() / "blur_map.png");
  ASSERT_EQ(map.width, expected.width);
  ASSERT_EQ(map.height, expected.height);
  float greatest = 0;
  for (std::size_t i = 0; i < map.values.size(); ++i)
    greatest = std::max(greatest, std::abs(map.values[i] * 255 - static_cast<float>(expected.rgba[i * 4])));
  EXPECT_LE(greatest, 1.0f);
}

TEST_F(PublishedFlip, LinearPictures) {
  const HdrFlip flip =
      hdr_flip(load_image_f(truth() / "hdr_ref.exr"), load_image_f(truth() / "hdr_test.exr"));
  EXPECT_NEAR(flip.start_exposure, 1.8978, 1e-4);
  EXPECT_NEAR(flip.stop_exposure, 2.6560, 1e-4);
  EXPECT_EQ(flip.exposures, 2);
  expect_near(summarise_flip(flip.map), {0.189940, 0.186099, 0.166900, 0.217539, 0.122800, 0.483472},
              tolerance);
}

TEST(Flip, IsZeroForEqualPictures) {
  const Image8 a = noisy(37, 70, 1);
  const FlipSummary summary = summarise_flip(flip_map(a, a));
  EXPECT_EQ(summary.max, 0);
  EXPECT_EQ(summary.weighted_median, 0);
  EXPECT_EQ(mean_flip(a, a), 0);
}

// Without edges only the colour difference is left. Lab of the sRGB green and blue from textbooks.
TEST(Flip, FlatPicturesAgainstTheFormula) {
  constexpr double green[] = {87.7347, -86.1827, 83.1793}, blue[] = {32.2970, 79.1875, -107.8602};
  const auto hunt = [](const double* lab, int c) { return 0.01 * lab[0] * lab[c]; };
  const double greatest = std::pow(
      green[0] - blue[0] + std::hypot(hunt(green, 1) - hunt(blue, 1), hunt(green, 2) - hunt(blue, 2)), 0.7);
  const double bend = 0.4 * greatest,
               black_white = 0.95 + 0.05 * (std::pow(100, 0.7) - bend) / (greatest - bend);
  EXPECT_NEAR(mean_flip(flat(30, 30, 0, 0, 0), flat(30, 30, 255, 255, 255)), black_white, 1e-5);
  EXPECT_NEAR(mean_flip(flat(30, 30, 0, 255, 0), flat(30, 30, 0, 0, 255)), 1, 1e-5);
  // CIELAB lightness of the display value 119 is 50.03: below the bend.
  EXPECT_NEAR(mean_flip(flat(30, 30, 0, 0, 0), flat(30, 30, 119, 119, 119)),
              0.95 / bend * std::pow(50.0344, 0.7), 1e-4);
}

TEST(Flip, IsSymmetric) {
  const Image8 a = noisy(90, 141, 1), b = noisy(90, 141, 2);
  EXPECT_EQ(flip_map(a, b).values, flip_map(b, a).values);
  const FlipSummary s = summarise_flip(flip_map(a, b));
  EXPECT_LT(0, s.min);
  EXPECT_LT(s.min, s.q1);
  EXPECT_LT(s.q1, s.weighted_median);
  EXPECT_LT(s.weighted_median, s.q3);
  EXPECT_LT(s.q3, s.max);
  EXPECT_LE(s.max, 1);
}

// Rows and columns are filtered one after the other: turned and mirrored pictures must give turned and
// mirrored maps, bands or not.
TEST(Flip, TurnsWithThePictures) {
  const Image8 a = noisy(40, 150, 1), b = noisy(40, 150, 2);
  const auto turned = [](const Image8& p) {
    Image8 t{.width = p.height, .height = p.width, .rgba = std::vector<std::uint8_t>(p.rgba.size())};
    for (int y = 0; y < t.height; ++y)
      for (int x = 0; x < t.width; ++x) std::copy_n(p.at(y, p.height - 1 - x), 4, t.at(x, y));
    return t;
  };
  const ImageF upright = flip_map(a, b), lying = flip_map(turned(a), turned(b));
  for (int y = 0; y < lying.height; ++y)
    for (int x = 0; x < lying.width; ++x)
      ASSERT_NEAR(*lying.at(x, y), *upright.at(y, upright.height - 1 - x), 2e-4) << x << ' ' << y;
}

TEST(Flip, OnePixelIsSeenTenPixelsFar) {
  Image8 a = flat(61, 140, 90, 120, 60), b = a;
  b.at(30, 66)[1] = 250;
  const ImageF map = flip_map(a, b);
  for (int y = 0; y < map.height; ++y)
    for (int x = 0; x < map.width; ++x)
      if (std::abs(x - 30) > 10 || std::abs(y - 66) > 10) { ASSERT_EQ(*map.at(x, y), 0) << x << ' ' << y; }
  EXPECT_GT(*map.at(30, 66), 0.1f);
  EXPECT_GT(*map.at(30 + 9, 66), 0);
  a.at(30, 66)[3] = 0;
  EXPECT_EQ(flip_map(a, b).values, map.values) << "alpha does not count";
}

TEST(Flip, PicturesOfOnePixel) {
  EXPECT_GT(mean_flip(flat(1, 1, 0, 0, 0), flat(1, 1, 255, 255, 255)), 0.96);
  EXPECT_EQ(mean_flip(flat(1, 1, 9, 9, 9), flat(1, 1, 9, 9, 9)), 0);
  EXPECT_EQ(summarise_flip(hdr_flip(flat_f(1, 1, 2), flat_f(1, 1, 2)).map).max, 0);
  EXPECT_GT(summarise_flip(hdr_flip(flat_f(1, 1, 2), flat_f(1, 1, 0.1f)).map).max, 0.5);
}

TEST(Flip, OverAMask) {
  const Image8 a = flat(60, 40, 90, 120, 60);
  Image8 b = a;
  std::vector<std::uint8_t> left(60 * 40), right(60 * 40);
  for (int y = 0; y < 40; ++y)
    for (int x = 0; x < 60; ++x) {
      if (x >= 40) b.at(x, y)[0] = 200;
      left[static_cast<std::size_t>(y * 60 + x)] = x < 30,
                                             right[static_cast<std::size_t>(y * 60 + x)] = x >= 50;
    }
  EXPECT_EQ(mean_flip(a, b, left), 0);
  EXPECT_NEAR(mean_flip(a, b, right), mean_flip(flat(30, 30, 90, 120, 60), flat(30, 30, 200, 120, 60)), 1e-4);
  EXPECT_THROW(mean_flip(a, b, std::vector<std::uint8_t>(60 * 40)), InputError);
  EXPECT_THROW(mean_flip(a, b, std::vector<std::uint8_t>(7, 1)), InputError);
  EXPECT_THROW(mean_flip(a, flat(40, 60, 0, 0, 0)), InputError);
}

TEST(Flip, WeightedPercentilesOfAMap) {
  // Sum 20: a quarter of it is passed within the 4, half and three quarters within the 13.
  const ImageF map{.width = 4, .height = 1, .channels = 1, .values = {0.13f, 0.01f, 0.02f, 0.04f}};
  const FlipSummary s = summarise_flip(map);
  EXPECT_FLOAT_EQ(static_cast<float>(s.mean), 0.05f);
  EXPECT_EQ(s.q1, static_cast<double>(0.04f));
  EXPECT_EQ(s.weighted_median, static_cast<double>(0.13f));
  EXPECT_EQ(s.q3, static_cast<double>(0.13f));
  EXPECT_EQ(s.min, static_cast<double>(0.01f));
  EXPECT_EQ(s.max, static_cast<double>(0.13f));
}

ImageF noisy_f(int width, int height, std::uint32_t seed, float scale) {
  ImageF picture = flat_f(width, height, 0);
  const std::vector<std::uint8_t> noise = test::noise(picture.values.size(), seed);
  for (std::size_t i = 0; i < noise.size(); ++i)
    picture.values[i] = scale * (1 + static_cast<float>(noise[i]));
  return picture;
}

TEST(HdrFlip, BrighterPicturesAreShownDarker) {
  const HdrFlip dim = hdr_flip(noisy_f(30, 80, 1, 0.01f), noisy_f(30, 80, 2, 0.01f));
  const HdrFlip bright = hdr_flip(noisy_f(30, 80, 1, 0.16f), noisy_f(30, 80, 2, 0.16f));
  EXPECT_NEAR(dim.start_exposure - bright.start_exposure, 4, 1e-5);
  EXPECT_NEAR(dim.stop_exposure - bright.stop_exposure, 4, 1e-5);
  for (std::size_t i = 0; i < dim.map.values.size(); ++i)
    ASSERT_NEAR(dim.map.values[i], bright.map.values[i], 1e-3);
}

TEST(HdrFlip, ExposuresComeFromTheReference) {
  ImageF a = flat_f(20, 20, 1), b = a;
  for (int i = 0; i < 3; ++i) b.at(3, 3)[i] = 64;
  const HdrFlip from_a = hdr_flip(a, b), from_b = hdr_flip(b, a);
  EXPECT_EQ(from_a.exposures, 2);
  EXPECT_NEAR(from_a.stop_exposure, from_a.start_exposure, 1e-9);
  EXPECT_EQ(from_b.exposures, 6);
  EXPECT_NEAR(from_b.stop_exposure - from_b.start_exposure, 6, 1e-9);
}

TEST(HdrFlip, BlackReferencesAndBackgrounds) {
  const HdrFlip black = hdr_flip(flat_f(9, 9, 0), flat_f(9, 9, 1));
  EXPECT_EQ(black.exposures, 2);
  EXPECT_EQ(black.start_exposure, 0);
  EXPECT_GT(summarise_flip(black.map).min, 0.5);
  ImageF head = flat_f(20, 20, 0);
  for (int i = 0; i < 90; ++i) head.at(i % 20, i / 20)[1] = 1 + static_cast<float>(i);
  const HdrFlip before_black = hdr_flip(head, head);
  EXPECT_NEAR(before_black.stop_exposure - before_black.start_exposure, std::log2(90 / 45.5), 1e-9);
  EXPECT_EQ(summarise_flip(before_black.map).max, 0);
}

TEST(HdrFlip, HostileValues) {
  ImageF a = flat_f(12, 12, 1), b = a;
  a.values[0] = std::numeric_limits<float>::max(), a.values[5] = -1,
  a.values[9] = std::numeric_limits<float>::quiet_NaN();
  a.values[40] = std::numeric_limits<float>::denorm_min(),
  b.values[3] = std::numeric_limits<float>::infinity();
  for (const float value : hdr_flip(a, b).map.values) {
    ASSERT_LE(0, value);
    ASSERT_LE(value, 1);
  }
  EXPECT_LE(hdr_flip(a, b).exposures, 30);
}

}  // namespace
}  // namespace dermis::image
