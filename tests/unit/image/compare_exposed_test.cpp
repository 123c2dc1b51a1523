// SPDX-License-Identifier: MIT
#include "image/compare_exposed.h"

#include <gtest/gtest.h>

#include "base/core/error.h"
#include "image/metrics.h"

namespace dermis::image {
namespace {

// A square of 8 x 8 pixels that count, of one value, in a picture of 16 x 8 whose other half does not.
ImageF half_covered(float value, float outside = 0) {
  ImageF picture{.width = 16, .height = 8, .channels = 4, .values = std::vector<float>(16 * 8 * 4)};
  for (int y = 0; y < 8; ++y)
    for (int x = 0; x < 16; ++x) {
      float* p = picture.at(x, y);
      p[0] = p[1] = p[2] = x < 8 ? value : outside;
      p[3] = x < 8 ? 1.0f : 0.0f;
    }
  return picture;
}

TEST(CompareExposed, EqualPictures) {
  const auto d = compare_exposed(half_covered(0.2f), half_covered(0.2f), ToneMap::filmic);
  ASSERT_TRUE(d.has_value());
  EXPECT_EQ(d->psnr_db, psnr_cap_db);
  EXPECT_EQ(d->flip_mean, 0);
  EXPECT_EQ(d->pixels, 64u);
}

// The same relative difference is found whether a picture is dim or glaring.
TEST(CompareExposed, ShowsWhatDarknessHides) {
  for (const float scale : {1e-5f, 1.0f, 20.0f}) {
    const auto d = compare_exposed(half_covered(0.2f * scale), half_covered(0.22f * scale), ToneMap::filmic);
    ASSERT_TRUE(d.has_value());
    EXPECT_GE(d->mean_display, 0.25) << scale;
    EXPECT_LE(d->mean_display, 0.5) << scale;
    EXPECT_LT(d->psnr_db, 40) << scale;
    EXPECT_GT(d->psnr_db, 25) << scale;
    EXPECT_GT(d->flip_mean, 0.005) << scale;
  }
}

TEST(CompareExposed, OnlyWhatIsCoveredInEitherCounts) {
  EXPECT_EQ(compare_exposed(half_covered(0.2f, 0), half_covered(0.2f, 0.5f), ToneMap::srgb)->psnr_db,
            psnr_cap_db);
  ImageF more = half_covered(0.2f);
  more.at(12, 4)[3] = 0.1f;
  EXPECT_EQ(compare_exposed(half_covered(0.2f), more, ToneMap::srgb)->pixels, 65u);
  EXPECT_EQ(compare_exposed(more, half_covered(0.2f), ToneMap::srgb)->pixels, 65u);
}

TEST(CompareExposed, NothingToCompare) {
  ImageF nothing = half_covered(0.2f);
  for (std::size_t i = 3; i < nothing.values.size(); i += 4) nothing.values[i] = 0;
  EXPECT_FALSE(compare_exposed(nothing, nothing, ToneMap::filmic).has_value());
  ImageF small{.width = 1, .height = 1, .channels = 4, .values = {1, 1, 1, 1}};
  EXPECT_THROW(compare_exposed(half_covered(0.2f), small, ToneMap::filmic), InputError);
}

TEST(CompareExposed, ABlackPictureEndsToo) {
  const auto d = compare_exposed(half_covered(0), half_covered(0), ToneMap::filmic);
  ASSERT_TRUE(d.has_value());
  EXPECT_EQ(d->mean_display, 0);
  EXPECT_EQ(d->psnr_db, psnr_cap_db);
}

}  // namespace
}  // namespace dermis::image
