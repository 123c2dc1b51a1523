// SPDX-License-Identifier: MIT
// What tests ask of a picture, and whether two are the same.
#pragma once

#include <gtest/gtest.h>

#include <array>
#include <cstdint>
#include <vector>

#include "dermis/renderer.h"
#include "image/image.h"

namespace dermis::tests {

/// Its light, four channels.
image::ImageF linear(const Picture& picture);
/// The same with the mean of times x times pixels in place of each: see super_sampled() in settings.h.
image::ImageF downsampled(const Picture& picture, int times);

/// Light as a display shows it. Bounds of PSNR and FLIP were chosen with the filmic curve.
image::Image8 shown(const image::ImageF& light, ToneMap tone_map = ToneMap::filmic);
image::Image8 shown(const Picture& picture);
/// What the picture itself says a display shows.
image::Image8 display(const Picture& picture);

/// Pixels of which more than this share is skin: 1 inside, 0 outside.
std::vector<std::uint8_t> skin_mask(const Picture& picture, float share = 0);

/// Pixels that are wholly skin. A value that is no number counts as the highest there is.
struct SkinRange {
  std::size_t pixels = 0;
  float low = 1e30f, high = -1e30f;
  std::array<double, 3> mean{};
};
SkinRange skin_range(const Picture& picture);

/// Red, green and blue over all pixels.
std::array<double, 3> sum(const Picture& picture);
std::array<double, 3> mean_colour(const Picture& picture);

/// What an optimisation may change: 40 dB are a root mean square of 2.55 of 255 display values, and FLIP,
/// which is 1 for black in place of white, may be a fiftieth on average.
inline constexpr double unseen_psnr_db = 40, unseen_flip = 0.02;

/// Over pixels that are skin in either, four channels each; prints both figures. On failure the pictures are
/// written (failure.h).
void expect_unseen(const image::ImageF& wanted, const image::ImageF& found);
void expect_unseen(const Picture& wanted, const Picture& found);

/// A half float rounds by this share of its value at most.
inline constexpr double half_rounding = 1.0 / 2048;

/// How far two targets of half floats that show the same may be apart: GPUs round to either side, a whole
/// step.
double target_rounding();

/// Of display values.
struct DisplayDifference {
  int largest = 0;
  double mean = 0;
};
DisplayDifference display_difference(const Picture& a, const Picture& b);

/// Linear light and display values. On failure the pictures are written (failure.h).
void expect_equal_bits(const Picture& wanted, const Picture& found);

/// Of a renderer and a session: linear light, equal to the bit on software devices, within a step of a half
/// float elsewhere. GPU drivers compile a shader otherwise in another pipeline, and round otherwise.
void expect_same_picture(const Picture& wanted, const Picture& found);

}  // namespace dermis::tests
