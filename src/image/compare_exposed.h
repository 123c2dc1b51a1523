// SPDX-License-Identifier: MIT
// Compares two linear pictures of one subject, where the subject is and at an exposure that shows it.
#pragma once

#include <cstdint>
#include <optional>

#include "image/image.h"
#include "image/tone_map.h"

namespace dermis::image {

struct ExposedDifference {
  double psnr_db = 0;    ///< of display values, see metrics.h
  double flip_mean = 0;  ///< see compare_flip.h
  /// of the reference over the pixels that count; 0.25 to 0.5 if any exposure reaches that
  double mean_display = 0;
  std::uint64_t pixels = 0;
};

/// Compares the pixels whose alpha is above 0 in either picture. Multiplies both pictures by one factor, a
/// power of 1.4 or 0.7, so that the mean display value of the reference is 0.25 to 0.5. In a picture that is
/// black or white everywhere, differences would not show. RGBA of one size. Returns nothing if no pixel
/// counts. Throws InputError for different sizes.
std::optional<ExposedDifference> compare_exposed(ImageF reference, ImageF test, ToneMap tone_map);

}  // namespace dermis::image
