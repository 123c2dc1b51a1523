// SPDX-License-Identifier: MIT
#include "dermis/compare.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <random>
#include <string>

#include "dermis/error.h"
#include "image/compare_flip.h"
#include "image/metrics.h"

namespace dermis {
namespace {

constexpr int width = 12, height = 8;
constexpr std::size_t pixels = 96;

/// Noise; alpha as well.
std::vector<std::uint8_t> display(unsigned seed, int channels) {
  std::mt19937 random(seed);
  std::vector<std::uint8_t> values(pixels * static_cast<std::size_t>(channels));
  for (std::uint8_t& value : values) value = static_cast<std::uint8_t>(random() % 256);
  return values;
}

std::vector<float> light(float value, int channels = 3) {
  return std::vector<float>(pixels * static_cast<std::size_t>(channels), value);
}

template <class Work>
std::string message_of(const Work& work) {
  try {
    work();
  } catch (const InputError& error) { return error.what(); }
  return "nothing was refused";
}

TEST(Compare, FlipIsThatOfTheImages) {
  const std::vector<std::uint8_t> a = display(1, 4), b = display(2, 4);
  const Flip found = flip(DisplayPixels{a, width, height}, DisplayPixels{b, width, height});
  const image::ImageF map = image::flip_map({width, height, a}, {width, height, b});
  EXPECT_EQ(found.map, map.values);
  EXPECT_DOUBLE_EQ(found.mean, image::summarise_flip(map).mean);
  EXPECT_GT(found.mean, 0.1);
  EXPECT_EQ(found.exposures, 0);
}

TEST(Compare, AlphaDoesNotCount) {
  const std::vector<std::uint8_t> a = display(1, 3), b = display(2, 3);
  std::vector<std::uint8_t> a4 = display(3, 4), b4 = display(4, 4);
  for (std::size_t i = 0; i < pixels; ++i)
    for (std::size_t c = 0; c < 3; ++c) a4[4 * i + c] = a[3 * i + c], b4[4 * i + c] = b[3 * i + c];
  const DisplayPixels with{a4, width, height}, without{b, width, height, 3};
  EXPECT_EQ(flip(with, {b4, width, height}).map, flip({a, width, height, 3}, without).map);
  EXPECT_EQ(psnr_db(with, {b4, width, height}), psnr_db({a, width, height, 3}, without));
}

TEST(Compare, RelativeErrorInClosedForm) {
  const std::vector<float> one = light(1), more = light(1.5f, 4), variance = light(0.04f);
  const LinearPixels reference{one, width, height, 3}, test{more, width, height, 4};
  EXPECT_NEAR(relative_mse(reference, test), 0.25 / 1.01, 1e-7);
  EXPECT_NEAR(relative_mse_less_noise(reference, {variance, width, height, 3}, test), (0.25 - 0.04) / 1.01,
              1e-7);
  EXPECT_NEAR(psnr_db({display(1, 3), width, height, 3}, {display(1, 3), width, height, 3}), 100, 1e-12);
}

TEST(Compare, AMaskLeavesPixelsOut) {
  const std::vector<float> one = light(1);
  std::vector<float> test = light(1);
  test[0] = 2;
  std::vector<std::uint8_t> mask(pixels, 0);
  mask[0] = 1;
  const LinearPixels a{one, width, height, 3}, b{test, width, height, 3};
  EXPECT_NEAR(relative_mse(a, b, mask), 1 / 1.01 / 3, 1e-7);
  EXPECT_GT(flip(a, b, mask).mean, 2 * flip(a, b).mean);
  mask[0] = 0, mask[pixels - 1] = 1;
  EXPECT_EQ(relative_mse(a, b, mask), 0);
}

TEST(Compare, WrongPixelsAreRefused) {
  const std::vector<float> one = light(1);
  const LinearPixels good{one, width, height, 3};
  const auto refused = [&](const LinearPixels& test) {
    return message_of([&] { relative_mse(good, test); });
  };
  EXPECT_EQ(refused({one, height, width, 3}), "test: is 8 x 12 pixels, reference is 12 x 8");
  EXPECT_EQ(refused({one, width, height, 4}), "test: has 288 values, 12 x 8 pixels of 4 are 384");
  EXPECT_EQ(refused({one, width, height, 2}),
            "test: must be pixels of 3 or 4 values, at least one, got 12 x 8 x 2");
  EXPECT_NE(refused({one, 0, height, 3}).find("at least one"), std::string::npos);

  std::vector<float> bad = one;
  bad[3 * (2 * width + 5) + 1] = std::numeric_limits<float>::quiet_NaN();
  EXPECT_EQ(refused({bad, width, height, 3}), "test: holds nan in the pixel 5, 2; values must be finite");
  EXPECT_NE(message_of([&] { flip(good, {bad, width, height, 3}); }).find("nan"), std::string::npos);
  const std::vector<float> negative = light(-1);
  EXPECT_NE(message_of([&] {
              relative_mse_less_noise(good, {negative, width, height, 3}, good);
            }).find("at least 0"),
            std::string::npos);

  const std::vector<std::uint8_t> small(4, 1), nothing(pixels, 0);
  EXPECT_EQ(message_of([&] { relative_mse(good, good, small); }),
            "mask: has 4 values, pictures have 96 pixels");
  EXPECT_NE(message_of([&] { relative_mse(good, good, nothing); }), "nothing was refused");
}

TEST(Compare, WhatATableCannotBeIsRefusedBeforeAnythingIsDrawn) {
  const auto refused = [](const SceneComparisonSettings& settings) {
    return message_of([&] { check_comparison(settings); });
  };
  EXPECT_NE(
      refused({.render = {}, .reference = {}, .techniques = {"lambret"}}).find("did you mean 'lambert'"),
      std::string::npos);
  EXPECT_EQ(refused({.render = {}, .reference = {}, .supersample = 17}),
            "supersample must be 1 to 16, got 17");
  EXPECT_EQ(refused({.render = {.output = {.width = 8192}}, .reference = {}, .supersample = 16}),
            "supersample must be at most 8 for pictures of 8192 pixels per side, got 16");
  const ReferencePicture truth;
  EXPECT_EQ(refused({.render = {.output = {.exposure_ev = {}}}, .reference = {}, .truth = &truth}),
            "output.exposure_ev cannot be chosen for a truth that is given, which was exposed before; give "
            "the number");
}

}  // namespace
}  // namespace dermis
