// SPDX-License-Identifier: MIT
#include "image/resize.h"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "dermis/error.h"
#include "image/colour.h"
#include "mip_chain.h"

namespace dermis::image {
namespace {

Image8 random_picture(int width, int height, bool opaque) {
  std::mt19937 random(3);
  Image8 picture{.width = width,
                 .height = height,
                 .rgba = std::vector<std::uint8_t>(static_cast<std::size_t>(width * height * 4))};
  for (std::size_t i = 0; i < picture.rgba.size(); ++i)
    picture.rgba[i] = opaque && i % 4 == 3 ? std::uint8_t{255} : static_cast<std::uint8_t>(random() >> 24);
  return picture;
}

TEST(Mips, Sizes) {
  const std::vector<Image8> chain = mip_chain(random_picture(20, 3, true), true);
  const std::pair<int, int> sizes[] = {{20, 3}, {10, 1}, {5, 1}, {2, 1}, {1, 1}};
  ASSERT_EQ(chain.size(), std::size(sizes));
  for (std::size_t i = 0; i < chain.size(); ++i) {
    EXPECT_EQ(std::pair(chain[i].width, chain[i].height), sizes[i]);
    EXPECT_EQ(chain[i].rgba.size(), static_cast<std::size_t>(sizes[i].first * sizes[i].second * 4));
  }
  EXPECT_EQ(mip_chain(random_picture(1, 1, true), false).size(), 1u);
  EXPECT_EQ(chain[0].rgba, random_picture(20, 3, true).rgba);
}

TEST(Mips, OneColourStaysThatColour) {
  for (int value = 0; value < 256; value += 5) {
    const Image8 base{.width = 13,
                      .height = 7,
                      .rgba = std::vector<std::uint8_t>(13 * 7 * 4, static_cast<std::uint8_t>(value))};
    for (const bool srgb : {false, true}) {
      for (const Image8& level : mip_chain(base, srgb)) {
        for (const std::uint8_t v : level.rgba)
          ASSERT_EQ(v, value) << "srgb " << srgb << " width " << level.width;
      }
    }
  }
}

TEST(Mips, BlackAndWhiteMeetInLinearLight) {
  const Image8 base{.width = 2, .height = 1, .rgba = {0, 0, 0, 255, 255, 255, 255, 255}};
  EXPECT_EQ(mip_chain(base, true)[1].rgba, (std::vector<std::uint8_t>{188, 188, 188, 255}));
  EXPECT_EQ(mip_chain(base, false)[1].rgba, (std::vector<std::uint8_t>{128, 128, 128, 255}));
}

// The last level is the mean of all of base, odd sides included: every pixel counts alike, and nothing is
// rounded on the way.
TEST(Mips, LastLevelIsTheMean) {
  for (const auto& [width, height] : {std::pair{64, 64}, {37, 51}, {100, 3}, {5, 5}}) {
    const Image8 base = random_picture(width, height, true);
    double plain[3] = {}, linear[3] = {};
    for (std::size_t i = 0; i < base.rgba.size(); ++i) {
      if (i % 4 == 3) continue;
      plain[i % 4] += base.rgba[i] / (static_cast<double>(base.rgba.size()) / 4);
      linear[i % 4] +=
          static_cast<double>(srgb8_to_linear(base.rgba[i])) / (static_cast<double>(base.rgba.size()) / 4);
    }
    const Image8 data = mip_chain(base, false).back();
    const Image8 colour = mip_chain(base, true).back();
    for (std::size_t c = 0; c < 3; ++c) {
      EXPECT_NEAR(data.rgba[c], plain[c], 0.51);
      EXPECT_NEAR(colour.rgba[c], 255 * static_cast<double>(linear_to_srgb(static_cast<float>(linear[c]))),
                  0.51);
    }
  }
}

TEST(Mips, HiddenColourDoesNotBleedIn) {
  const Image8 card{.width = 2, .height = 1, .rgba = {200, 100, 50, 255, 0, 255, 0, 0}};
  const std::vector<std::uint8_t> pixel = mip_chain(card, true)[1].rgba;
  EXPECT_NEAR(pixel[0], 200, 1);
  EXPECT_NEAR(pixel[1], 100, 1);
  EXPECT_NEAR(pixel[2], 50, 1);
  EXPECT_EQ(pixel[3], 128);
  // An opaque material may leave nonsense in its alpha: where all of it is 0 the colour is still the average.
  const Image8 no_alpha{.width = 2, .height = 1, .rgba = {0, 0, 0, 0, 255, 255, 255, 0}};
  EXPECT_EQ(mip_chain(no_alpha, true)[1].rgba, (std::vector<std::uint8_t>{188, 188, 188, 0}));
}

TEST(Downsample, AveragesBlocks) {
  ImageF picture{.width = 6, .height = 4, .channels = 2, .values = {}};
  for (int i = 0; i < 6 * 4 * 2; ++i) picture.values.push_back(static_cast<float>(i * i % 17));
  EXPECT_EQ(downsample_box(picture, 1).values, picture.values);
  const ImageF small = downsample_box(picture, 2);
  ASSERT_EQ(small.width, 3);
  ASSERT_EQ(small.height, 2);
  for (int y = 0; y < 2; ++y) {
    for (int x = 0; x < 3; ++x) {
      for (int c = 0; c < 2; ++c) {
        const float sum = picture.at(2 * x, 2 * y)[c] + picture.at(2 * x + 1, 2 * y)[c] +
                          picture.at(2 * x, 2 * y + 1)[c] + picture.at(2 * x + 1, 2 * y + 1)[c];
        EXPECT_EQ(small.at(x, y)[c], sum / 4);
      }
    }
  }
}

TEST(Downsample, AFactorThatDoesNotDivideIsAMistakeOfTheCaller) {
  const ImageF picture{.width = 5, .height = 4, .channels = 1, .values = std::vector<float>(20)};
  EXPECT_THROW(downsample_box(picture, 2), InternalError);
}

}  // namespace
}  // namespace dermis::image
