// SPDX-License-Identifier: MIT
// Compares two pictures over a region by all metrics; the first picture is the reference.
#pragma once

#include <cstdint>
#include <filesystem>
#include <optional>
#include <span>
#include <vector>

#include "image/compare_flip.h"
#include "image/image.h"
#include "image/tone_map.h"

namespace dermis::image {

/// One byte per pixel, 0 = does not count. Empty: all pixels count.
using Region = std::vector<std::uint8_t>;

/// Loads a PNG of the given size as a region: pixels whose R, G and B are not all 0. Throws InputError for
/// another size or an empty region.
Region load_region(const std::filesystem::path& path, int width, int height);

/// Tests whether the difference is noise: z = (test - reference) / sqrt(variance), per pixel and channel.
struct ZTest {
  double beyond_2 = 0;       ///< share of values with |z| > 2; Gaussian noise: 0.0455
  double beyond_3 = 0;       ///< share of values with |z| > 3; Gaussian noise: 0.0027
  std::uint64_t values = 0;  ///< pixels times 3
};

/// Tests with the variance of each pixel's value (squared standard error, not variance of one sample), 3 or 4
/// channels; variances of both pictures are added if both are noisy. If a variance is 0, any difference is
/// beyond. Throws InputError for other sizes, a negative variance, an empty region.
ZTest z_test(const ImageF& reference, const ImageF& test, std::span<const ImageF> variances,
             const Region& region = {});

struct Comparison {
  FlipSummary flip;
  double psnr_db = 0;        ///< of display values, see metrics.h
  double rel_mse = 0;        ///< of linear light, see metrics.h
  std::uint64_t pixels = 0;  ///< number of pixels that count
  ImageF flip_map;           ///< of all pixels, inside and outside the region
  double start_exposure = 0, stop_exposure = 0;
  int exposures = 0;       ///< 0: display pictures, not HDR-FLIP
  std::optional<ZTest> z;  ///< if variances were given
};

/// Compares display pictures: FLIP, PSNR of their values, relative error of their linear light. Throws
/// InputError as the parts do.
Comparison compare(const Image8& reference, const Image8& test, const Region& region = {});
/// Compares linear pictures of 3 or 4 channels: HDR-FLIP, PSNR after the tone map, relative error.
Comparison compare(const ImageF& reference, const ImageF& test, ToneMap tone_map,
                   std::span<const ImageF> variances = {}, const Region& region = {});

}  // namespace dermis::image
