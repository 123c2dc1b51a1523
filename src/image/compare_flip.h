// SPDX-License-Identifier: MIT
// FLIP: how large the difference between two pictures looks to somebody who flips between them, 0 (none) to
// 1, for every pixel.
//
// [ANAMOF20] Andersson, Nilsson, Akenine-Moller, Oskarsson, Astrom, Fairchild: FLIP: A Difference Evaluator
// for Alternating Images. HPG 2020 [ANSA21] Andersson, Nilsson, Shirley, Akenine-Moller: Visualizing Errors
// in Rendered High Dynamic Range Images. Eurographics 2021
//
// Values are those of the authors' own implementation to about 1e-5, seen as they assume: 0.7 m from a screen
// 0.7 m wide with 3840 pixels.
#pragma once

#include <cstdint>
#include <span>

#include "image/image.h"

namespace dermis::image {

/// 0.7 m * (3840 pixels / 0.7 m) * pi / 180 degrees.
inline constexpr double flip_pixels_per_degree = 67.02064327658226;

/// FLIP of two display pictures (sRGB; alpha does not count): 1 channel, 0 to 1, of their size. Symmetric,
/// and 0 where nothing differs within ten pixels. Takes memory for the map and for some hundred rows.
/// InputError: pictures of different sizes.
ImageF flip_map(const Image8& reference, const Image8& test);

/// [ANSA21]: the two pictures are shown at several exposures with the ACES curve, and each pixel keeps its
/// greatest FLIP.
struct HdrFlip {
  ImageF map;                 ///< 1 channel, 0 to 1
  double start_exposure = 0;  ///< the brightest pixel of the reference shows as 0.85
  double stop_exposure = 0;   ///< its median pixel does
  int exposures = 0;          ///< evenly from start to stop, about one a stop, at least 2
};

/// HDR-FLIP of two linear pictures of 3 or 4 channels (alpha does not count). The exposures come from the
/// reference alone, so it is not symmetric. Departures from the authors, who do not say what to do: black
/// pixels stay out of the median if more than half are black (a head before black would need infinite
/// exposure); the median is taken as at least 2^-30 of the greatest value; a reference without light is shown
/// at exposure 0; negative values are shown as black. InputError: pictures of different sizes.
HdrFlip hdr_flip(const ImageF& reference, const ImageF& test);

/// Aggregates of a map. The weighted percentiles are those of [ANAMOF20]: half of the summed error lies in
/// pixels up to the weighted median.
struct FlipSummary {
  double mean = 0, weighted_median = 0, q1 = 0, q3 = 0, min = 0, max = 0;
};

/// mask: empty (all pixels count) or one byte per pixel, 0 = does not count. InputError: a mask of another
/// size or one that selects no pixel.
FlipSummary summarise_flip(const ImageF& map, std::span<const std::uint8_t> mask = {});

/// The mean of flip_map over a mask: what a benchmark reports.
double mean_flip(const Image8& reference, const Image8& test, std::span<const std::uint8_t> mask = {});

}  // namespace dermis::image
