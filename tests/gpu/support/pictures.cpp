// SPDX-License-Identifier: MIT
#include "gpu/support/pictures.h"

#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <cstring>

#include "gpu/support/failure.h"
#include "gpu/support/renderer.h"
#include "image/compare_flip.h"
#include "image/metrics.h"
#include "image/resize.h"
#include "image/tone_map.h"

namespace dermis::tests {

image::ImageF linear(const Picture& picture) {
  return {.width = picture.width, .height = picture.height, .channels = 4, .values = picture.linear_rgba};
}

image::ImageF downsampled(const Picture& picture, int times) {
  return image::downsample_box(linear(picture), times);
}

image::Image8 shown(const image::ImageF& light, ToneMap tone_map) {
  return image::to_display(light, tone_map);
}

image::Image8 shown(const Picture& picture) { return shown(linear(picture)); }

image::Image8 display(const Picture& picture) {
  return {.width = picture.width, .height = picture.height, .rgba = picture.display_rgba};
}

std::vector<std::uint8_t> skin_mask(const Picture& picture, float share) {
  std::vector<std::uint8_t> mask(picture.linear_rgba.size() / 4);
  for (std::size_t i = 0; i < mask.size(); ++i) mask[i] = picture.linear_rgba[4 * i + 3] > share;
  return mask;
}

SkinRange skin_range(const Picture& picture) {
  SkinRange range;
  for (std::size_t i = 0; i + 3 < picture.linear_rgba.size(); i += 4) {
    if (picture.linear_rgba[i + 3] < 1 - 1e-3f) continue;
    ++range.pixels;
    for (std::size_t c = 0; c < 3; ++c) {
      const float value = picture.linear_rgba[i + c];
      range.low = std::min(range.low, value == value ? value : 0.0f);
      range.high = std::max(range.high, value == value ? value : 1e30f);
      range.mean[c] += static_cast<double>(value);
    }
  }

  for (double& m : range.mean) m /= static_cast<double>(std::max<std::size_t>(range.pixels, 1));
  return range;
}

std::array<double, 3> sum(const Picture& picture) {
  std::array<double, 3> total{};
  for (std::size_t i = 0; i + 3 < picture.linear_rgba.size(); i += 4)
    for (std::size_t c = 0; c < 3; ++c) total[c] += static_cast<double>(picture.linear_rgba[i + c]);
  return total;
}

std::array<double, 3> mean_colour(const Picture& picture) {
  std::array<double, 3> mean = sum(picture);
  for (double& m : mean) m /= static_cast<double>(picture.linear_rgba.size() / 4);
  return mean;
}

DisplayDifference display_difference(const Picture& a, const Picture& b) {
  DisplayDifference d;
  for (std::size_t i = 0; i < a.display_rgba.size(); ++i) {
    const int distance = std::abs(a.display_rgba[i] - b.display_rgba[i]);
    d.largest = std::max(d.largest, distance);
    d.mean += distance / static_cast<double>(a.display_rgba.size());
  }
  return d;
}

void expect_unseen(const image::ImageF& wanted, const image::ImageF& found) {
  ASSERT_EQ(wanted.values.size(), found.values.size());
  std::vector<std::uint8_t> skin(wanted.values.size() / 4);
  for (std::size_t i = 0; i < skin.size(); ++i)
    skin[i] = wanted.values[4 * i + 3] > 0 || found.values[4 * i + 3] > 0;

  const double psnr_db = image::psnr_db(shown(wanted), shown(found), skin),
               flip = image::mean_flip(shown(wanted), shown(found), skin);
  std::printf("%.1f dB, FLIP %.4f\n", psnr_db, flip);
  EXPECT_GE(psnr_db, unseen_psnr_db) << write_failure(wanted, found);
  EXPECT_LE(flip, unseen_flip) << write_failure(wanted, found);
}

void expect_unseen(const Picture& wanted, const Picture& found) {
  expect_unseen(linear(wanted), linear(found));
}

void expect_equal_bits(const Picture& wanted, const Picture& found) {
  ASSERT_EQ(wanted.width, found.width);
  ASSERT_EQ(wanted.height, found.height);
  ASSERT_EQ(wanted.linear_rgba.size(), found.linear_rgba.size());

  const bool equal = std::memcmp(wanted.linear_rgba.data(), found.linear_rgba.data(),
                                 wanted.linear_rgba.size() * sizeof(float)) == 0;
  EXPECT_TRUE(equal) << write_failure(linear(wanted), linear(found));
  EXPECT_EQ(wanted.display_rgba, found.display_rgba);
}

double target_rounding() { return on_software() ? half_rounding : 2 * half_rounding; }

void expect_same_picture(const Picture& wanted, const Picture& found) {
  if (on_software()) return expect_equal_bits(wanted, found);
  ASSERT_EQ(wanted.linear_rgba.size(), found.linear_rgba.size());

  std::size_t apart = 0;
  double most = 0;
  for (std::size_t i = 0; i < wanted.linear_rgba.size(); ++i) {
    const double a = double{wanted.linear_rgba[i]}, b = double{found.linear_rgba[i]};
    apart += a != b;
    most = std::max(most, std::abs(a - b) / std::max({std::abs(a), std::abs(b), 1e-4}));
  }
  if (apart > 0) std::printf("%zu of %zu values differ\n", apart, wanted.linear_rgba.size());
  EXPECT_LE(most, 1.01 * target_rounding()) << write_failure(linear(wanted), linear(found));
  EXPECT_LE(apart, wanted.linear_rgba.size() / 200);
}

}  // namespace dermis::tests
