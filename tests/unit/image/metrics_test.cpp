// SPDX-License-Identifier: MIT
#include "image/metrics.h"

#include <gtest/gtest.h>

#include <cmath>

#include "base/core/error.h"

namespace dermis::image {
namespace {

Image8 grey(int width, int height, std::uint8_t value) {
  return {.width = width,
          .height = height,
          .rgba = std::vector<std::uint8_t>(static_cast<std::size_t>(width * height * 4), value)};
}

TEST(Psnr, ClosedForms) {
  EXPECT_EQ(psnr_db(grey(4, 3, 9), grey(4, 3, 9)), 100);
  EXPECT_NEAR(psnr_db(grey(4, 3, 0), grey(4, 3, 255)), 0, 1e-12);
  EXPECT_NEAR(psnr_db(grey(4, 3, 100), grey(4, 3, 101)), 20 * std::log10(255.0), 1e-12);
  Image8 one = grey(10, 10, 50);
  one.at(3, 7)[1] = 60;  // 100 / 300 on average
  EXPECT_NEAR(psnr_db(grey(10, 10, 50), one), 10 * std::log10(255.0 * 255.0 * 3), 1e-12);
  one.at(3, 7)[1] = 50;
  one.at(3, 7)[3] = 0;
  EXPECT_EQ(psnr_db(grey(10, 10, 50), one), 100) << "alpha does not count";
}

TEST(Psnr, IsCappedForOneStepInAHugePicture) {
  const Image8 a = grey(2000, 1200, 50);
  Image8 b = a;
  b.rgba[0] = 51;  // 116.7 dB
  EXPECT_EQ(psnr_db(a, b), 100);
}

TEST(Psnr, MaskSelects) {
  const Image8 a = grey(2, 2, 50);
  Image8 b = a;
  b.at(0, 0)[0] = b.at(0, 0)[1] = b.at(0, 0)[2] = 60;
  const std::uint8_t without[] = {0, 1, 1, 1};
  const std::uint8_t only[] = {255, 0, 0, 0};
  EXPECT_EQ(psnr_db(a, b, without), 100);
  EXPECT_NEAR(psnr_db(a, b, only), 20 * std::log10(25.5), 1e-12);
  EXPECT_NEAR(psnr_db(a, b), 10 * std::log10(255.0 * 255.0 / 25), 1e-12);
}

TEST(Psnr, BadInput) {
  const std::uint8_t none[4] = {};
  EXPECT_THROW(psnr_db(grey(2, 3, 0), grey(3, 2, 0)), InputError);
  EXPECT_THROW(psnr_db(grey(2, 2, 0), grey(2, 2, 0), none), InputError);
  EXPECT_THROW(psnr_db(grey(2, 3, 0), grey(2, 3, 0), none), InputError);
}

}  // namespace
}  // namespace dermis::image
