// SPDX-License-Identifier: MIT
#include "image/compare.h"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "base/core/error.h"
#include "image/codec.h"
#include "image/colour.h"
#include "image/compare_map.h"
#include "image/metrics.h"

namespace dermis::image {
namespace {

ImageF flat(int width, int height, float value, int channels = 3) {
  return {.width = width,
          .height = height,
          .channels = channels,
          .values = std::vector<float>(static_cast<std::size_t>(width * height * channels), value)};
}

TEST(RelMse, ClosedForms) {
  EXPECT_EQ(rel_mse(flat(4, 3, 0.3f), flat(4, 3, 0.3f)), 0);
  EXPECT_DOUBLE_EQ(rel_mse(flat(4, 3, 0), flat(4, 3, 1)), 100);
  EXPECT_DOUBLE_EQ(rel_mse(flat(4, 3, 1), flat(4, 3, 3)), 4 / 1.01);
  EXPECT_DOUBLE_EQ(rel_mse(flat(4, 3, 1), flat(4, 3, 3, 4)), 4 / 1.01) << "alpha does not count";
  ImageF one = flat(10, 10, 1);
  one.at(3, 7)[1] = 2;
  EXPECT_DOUBLE_EQ(rel_mse(flat(10, 10, 1), one), 1 / 1.01 / 300);
  std::vector<std::uint8_t> mask(100);
  mask[73] = 1;
  EXPECT_DOUBLE_EQ(rel_mse(flat(10, 10, 1), one, mask), 1 / 1.01 / 3);
  // Squares of the greatest floats still fit.
  EXPECT_TRUE(std::isfinite(rel_mse(flat(1, 1, 0), flat(1, 1, std::numeric_limits<float>::max()))));
}

TEST(RelMse, BadInput) {
  EXPECT_THROW(rel_mse(flat(2, 3, 0), flat(3, 2, 0)), InputError);
  EXPECT_THROW(rel_mse(flat(2, 2, 0), flat(2, 2, 0), std::vector<std::uint8_t>(4)), InputError);
  EXPECT_THROW(rel_mse(flat(2, 2, 0), flat(2, 2, 0), std::vector<std::uint8_t>(3, 1)), InputError);
}

// Noise of 15 %: the divisor of a noisy pixel itself would prefer the darker picture.
TEST(RelMse, LessNoiseHasNoPreference) {
  constexpr float truth = 0.5f, deviation = 0.075f;
  ImageF noisy = flat(256, 256, truth);
  std::mt19937 random(1);
  std::normal_distribution<float> noise(0, deviation);
  for (float& value : noisy.values) value += noise(random);
  const ImageF variance = flat(256, 256, deviation * deviation);
  const ImageF brighter = flat(256, 256, 1.03f * truth), darker = flat(256, 256, 0.97f * truth);
  const std::vector<std::uint8_t> all(256 * 256, 1);

  const double expected = 0.015 * 0.015 / (0.5 * 0.5 + 0.01);
  EXPECT_NEAR(rel_mse_less_noise(noisy, variance, flat(256, 256, truth), all, all), 0, 3e-4);
  EXPECT_NEAR(rel_mse_less_noise(noisy, variance, brighter, all, all), expected, 3e-4);
  EXPECT_NEAR(rel_mse_less_noise(noisy, variance, darker, all, all), expected, 3e-4);
  EXPECT_GT(rel_mse(noisy, brighter) - rel_mse(noisy, darker), 5 * expected) << "what it is there for";
}

TEST(RelMse, LessNoiseDividesByTheNeighbours) {
  ImageF reference = flat(3, 3, 2);
  reference.at(1, 1)[0] = reference.at(1, 1)[1] = reference.at(1, 1)[2] = 1;
  std::vector<std::uint8_t> middle(9), alone(9), all(9, 1);
  middle[4] = alone[4] = 1;
  EXPECT_DOUBLE_EQ(rel_mse_less_noise(reference, flat(3, 3, 0), flat(3, 3, 3), middle, all), 4 / 4.01);
  EXPECT_DOUBLE_EQ(rel_mse_less_noise(reference, flat(3, 3, 0), flat(3, 3, 3), middle, alone), 4 / 1.01);
  EXPECT_DOUBLE_EQ(rel_mse_less_noise(reference, flat(3, 3, 1), flat(3, 3, 3), middle, all), 3 / 4.01);
  EXPECT_THROW(rel_mse_less_noise(reference, flat(3, 3, 1), flat(3, 3, 3), std::vector<std::uint8_t>(9), all),
               InputError);
}

class ZTests : public testing::Test {
 protected:
  ZTests() {
    std::mt19937 random(1);
    std::normal_distribution<float> noise;
    for (std::size_t i = 0; i < test_.values.size(); ++i) {
      variance_.values[i] = 0.01f + 0.001f * static_cast<float>(i % 7);
      test_.values[i] += std::sqrt(variance_.values[i]) * noise(random);
    }
  }
  ImageF reference_ = flat(200, 150, 1), test_ = reference_, variance_ = reference_;
};

TEST_F(ZTests, NoiseOfTheStatedVariance) {
  const ZTest z = z_test(reference_, test_, std::span(&variance_, 1));
  EXPECT_EQ(z.values, 90000u);
  // Three standard errors of a share of 90,000.
  EXPECT_NEAR(z.beyond_2, 0.0455, 3 * std::sqrt(0.0455 / 90000));
  EXPECT_NEAR(z.beyond_3, 0.0027, 3 * std::sqrt(0.0027 / 90000));
}

TEST_F(ZTests, VariancesAddUp) {
  const ImageF both[] = {variance_, variance_};
  // Twice the variance: |noise| > 2 sqrt(2) of its own standard errors.
  EXPECT_NEAR(z_test(reference_, test_, both).beyond_2, std::erfc(2.0), 3 * std::sqrt(0.0047 / 90000));
}

TEST_F(ZTests, ADifferenceThatIsNoNoise) {
  for (float& value : test_.values) value += 0.5f;
  EXPECT_GT(z_test(reference_, test_, std::span(&variance_, 1)).beyond_3, 0.9);
}

TEST_F(ZTests, WithoutVarianceEveryDifferenceCounts) {
  const ImageF none = flat(2, 1, 0), a = none;
  ImageF b = none;
  b.values[4] = 1e-20f;
  const ZTest z = z_test(a, b, std::span(&none, 1));
  EXPECT_DOUBLE_EQ(z.beyond_2, 1.0 / 6);
  EXPECT_DOUBLE_EQ(z.beyond_3, 1.0 / 6);
  EXPECT_EQ(z_test(a, b, std::span(&none, 1), {1, 0}).beyond_3, 0);
}

TEST_F(ZTests, BadInput) {
  const ImageF small = flat(2, 2, 1);
  EXPECT_THROW(z_test(reference_, test_, std::span(&small, 1)), InputError);
  EXPECT_THROW(z_test(reference_, small, std::span(&variance_, 1)), InputError);
  EXPECT_THROW(z_test(small, small, std::span(&small, 1), {1}), InputError);
  EXPECT_THROW(z_test(small, small, std::span(&small, 1), {0, 0, 0, 0}), InputError);
  const ImageF negative = flat(2, 2, -1);
  EXPECT_THROW(z_test(small, small, std::span(&negative, 1)), InputError);
}

TEST(Compare, LinearPicturesThroughTheToneMap) {
  const ImageF a = flat(20, 10, 0.5f), b = flat(20, 10, 0.6f);
  const Colour colour_a{0.5f, 0.5f, 0.5f}, colour_b{0.6f, 0.6f, 0.6f};
  for (const ToneMap tone_map : {ToneMap::natural, ToneMap::filmic, ToneMap::srgb, ToneMap::linear}) {
    const double step = to_display8(tone_map, colour_b)[0] - to_display8(tone_map, colour_a)[0];
    EXPECT_NEAR(compare(a, b, tone_map).psnr_db, 20 * std::log10(255 / step), 1e-9);
  }
  const Comparison all = compare(a, b, ToneMap::filmic);
  EXPECT_EQ(all.exposures, 2);
  EXPECT_EQ(all.pixels, 200u);
  EXPECT_FALSE(all.z.has_value());
  EXPECT_NEAR(all.rel_mse, 0.01 / 0.26, 1e-6);
  EXPECT_GT(all.flip.mean, 0);
  Region region(200);
  region[3] = 1;
  EXPECT_EQ(compare(a, b, ToneMap::filmic, {}, region).pixels, 1u);
  EXPECT_TRUE(compare(a, b, ToneMap::filmic, std::span(&a, 1)).z.has_value());
}

TEST(Compare, DisplayPictures) {
  const Image8 a = to_display(flat(20, 10, 0.5f), ToneMap::srgb),
               b = to_display(flat(20, 10, 0.6f), ToneMap::srgb);
  const Comparison same = compare(a, a), other = compare(a, b);
  EXPECT_EQ(same.psnr_db, 100);
  EXPECT_EQ(same.rel_mse, 0);
  EXPECT_EQ(same.flip.max, 0);
  EXPECT_EQ(other.exposures, 0);
  EXPECT_EQ(other.psnr_db, psnr_db(a, b));
  const double was = srgb8_to_linear(a.rgba[0]), is = srgb8_to_linear(b.rgba[0]);
  EXPECT_NEAR(other.rel_mse, (is - was) * (is - was) / (was * was + 0.01), 1e-9) << "of linear light";
}

TEST(ErrorColours, FromBlackToPaleYellow) {
  using Colour = std::array<std::uint8_t, 3>;
  EXPECT_EQ(magma(0), (Colour{0, 0, 4}));
  EXPECT_EQ(magma(1), (Colour{252, 253, 191}));
  EXPECT_EQ(magma(-1), magma(0));
  EXPECT_EQ(magma(7), magma(1));
  EXPECT_EQ(magma(std::nanf("")), magma(0));

  // Entry 128 of the published table: 0.716387, 0.214982, 0.475290.
  for (const auto& [c, published] : {std::pair(0, 0.716387), std::pair(1, 0.214982), std::pair(2, 0.475290)})
    EXPECT_NEAR(magma(128 / 255.0f)[static_cast<std::size_t>(c)], published * 255, 3);

  double before = -1;
  for (int i = 0; i <= 255; ++i) {
    const Colour m = magma(static_cast<float>(i) / 255);
    const double brightness =
        0.2126 * srgb8_to_linear(m[0]) + 0.7152 * srgb8_to_linear(m[1]) + 0.0722 * srgb8_to_linear(m[2]);
    EXPECT_GE(brightness, before) << i;
    before = brightness;
  }

  const Image8 picture = error_colours({.width = 3, .height = 1, .channels = 1, .values = {0, 0.25f, 1}},
                                       0.25f, Region{1, 1, 0});
  EXPECT_EQ(picture.at(0, 0)[2], 4);
  EXPECT_EQ(picture.at(1, 0)[1], 253);
  EXPECT_EQ(picture.at(2, 0)[0], picture.at(2, 0)[2]) << "outside is grey";
}

}  // namespace
}  // namespace dermis::image
