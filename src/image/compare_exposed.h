// SPDX-License-Identifier: MIT
// How far two linear pictures of one subject are apart where the subject is, shown neither too dark nor too
// bright to see it.
#pragma once

#include <cstdint>
#include <optional>

#include "image/image.h"
#include "image/tone_map.h"

namespace dermis::image {

struct ExposedDifference {
  double psnr_db = 0;    ///< of display values, see metrics.h
  double flip_mean = 0;  ///< see compare_flip.h
  /// of the reference over the pixels that count, 0.25 to 0.5 unless no exposure makes it so
  double mean_display = 0;
  std::uint64_t pixels = 0;
};

/// Over the pixels whose alpha is above 0 in either picture, after both were multiplied by one factor, a
/// power of 1.4 or 0.7, under which their mean display value in the reference is 0.25 to 0.5: differences of
/// a picture that is black or white everywhere do not show. RGBA of one size. None if no pixel counts.
/// InputError: different sizes.
std::optional<ExposedDifference> compare_exposed(ImageF reference, ImageF test, ToneMap tone_map);

}  // namespace dermis::image
