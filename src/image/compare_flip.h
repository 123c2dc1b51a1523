// SPDX-License-Identifier: MIT
// FLIP: how large the difference between two pictures looks to an observer who flips between them, per pixel,
// 0 (none) to 1. Values agree with the authors' implementation to about 1e-5, for their viewing conditions:
// 0.7 m from a screen 0.7 m wide with 3840 pixels.
// Based on:
// [ANAMOF20] Andersson, Nilsson, Akenine-Moller, Oskarsson, Astrom, Fairchild: FLIP: A Difference Evaluator
//            for Alternating Images. HPG 2020
// [ANSA21]   Andersson, Nilsson, Shirley, Akenine-Moller: Visualizing Errors in Rendered High Dynamic Range
//            Images. Eurographics 2021
#pragma once

#include <cstdint>
#include <span>

#include "image/image.h"

namespace dermis::image {

/// 0.7 m * (3840 pixels / 0.7 m) * pi / 180 degrees.
inline constexpr double flip_pixels_per_degree = 67.02064327658226;

/// Returns FLIP of two display pictures (sRGB; alpha does not count): 1 channel, 0 to 1, of their size.
/// Symmetric, and 0 where nothing differs within ten pixels. Takes memory for the map and for about a hundred
/// rows. Throws InputError for different sizes.
ImageF flip_map(const Image8& reference, const Image8& test);

/// [ANSA21]: both pictures are shown at several exposures with the ACES curve, and each pixel keeps its
/// largest FLIP.
struct HdrFlip {
  ImageF map;                 ///< 1 channel, 0 to 1
  double start_exposure = 0;  ///< at which the brightest pixel of the reference shows as 0.85
  double stop_exposure = 0;   ///< at which its median pixel does
  int exposures = 0;          ///< evenly from start to stop, about one per stop, at least 2
};

/// Returns HDR-FLIP of two linear pictures of 3 or 4 channels (alpha does not count). Not symmetric: the
/// exposures come from the reference alone. Cases that the authors leave open: if more than half of the
/// pixels are black, the median ignores black pixels (a head in front of black would need infinite exposure).
/// The median is at least 2^-30 of the largest value. A reference without light is shown at exposure 0, and
/// negative values are shown as black. Throws InputError for different sizes.
HdrFlip hdr_flip(const ImageF& reference, const ImageF& test);

/// Statistics of a map. The weighted percentiles are those of [ANAMOF20]: half of the summed error lies in
/// pixels up to the weighted median.
struct FlipSummary {
  double mean = 0, weighted_median = 0, q1 = 0, q3 = 0, min = 0, max = 0;
};

/// Returns the statistics over a mask, empty (all pixels count) or one byte per pixel, 0 = does not count.
/// Throws InputError for a mask of another size or without a pixel.
FlipSummary summarise_flip(const ImageF& map, std::span<const std::uint8_t> mask = {});

/// Returns the mean of flip_map over a mask; benchmarks report it.
double mean_flip(const Image8& reference, const Image8& test, std::span<const std::uint8_t> mask = {});

}  // namespace dermis::image
