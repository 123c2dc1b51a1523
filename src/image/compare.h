// SPDX-License-Identifier: MIT
// Two pictures of the same thing, the first of which is the reference: every metric at once, over a region.
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

/// One byte per pixel: 0 = does not count. Empty: all pixels count.
using Region = std::vector<std::uint8_t>;

/// A PNG of the given size; pixels whose R, G and B are not all 0 are inside. InputError: another size,
/// nothing inside.
Region load_region(const std::filesystem::path& path, int width, int height);

/// Is the difference noise? z = (test - reference) / sqrt(variance), per pixel and channel.
struct ZTest {
  double beyond_2 = 0;       ///< share of values with |z| > 2; Gaussian noise: 0.0455
  double beyond_3 = 0;       ///< share of values with |z| > 3; Gaussian noise: 0.0027
  std::uint64_t values = 0;  ///< pixels times 3
};

/// variances: of each pixel's value (squares of standard errors, not of one sample), 3 or 4 channels; those
/// of both pictures if both are noisy: they add up. Where the variance is 0 any difference is beyond.
/// InputError: other sizes, a negative variance, an empty region.
ZTest z_test(const ImageF& reference, const ImageF& test, std::span<const ImageF> variances,
             const Region& region = {});

struct Comparison {
  FlipSummary flip;
  double psnr_db = 0;        ///< of display values, see metrics.h
  double rel_mse = 0;        ///< of linear light, see metrics.h
  std::uint64_t pixels = 0;  ///< that count
  ImageF flip_map;           ///< of all pixels, whatever the region
  double start_exposure = 0, stop_exposure = 0;
  int exposures = 0;       ///< 0: display pictures, not HDR-FLIP
  std::optional<ZTest> z;  ///< where variances were given
};

/// Display pictures: FLIP, PSNR of their values, relative error of their linear light. InputError: as the
/// parts.
Comparison compare(const Image8& reference, const Image8& test, const Region& region = {});
/// Linear pictures of 3 or 4 channels: HDR-FLIP, PSNR after the tone map, relative error.
Comparison compare(const ImageF& reference, const ImageF& test, ToneMap tone_map,
                   std::span<const ImageF> variances = {}, const Region& region = {});

}  // namespace dermis::image
