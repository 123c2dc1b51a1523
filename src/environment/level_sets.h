// SPDX-License-Identifier: MIT
/// Finds regions of a picture that are brighter than everything around them, and small on the sphere.
#pragma once

#include <cstdint>
#include <glm/glm.hpp>
#include <vector>

#include "image/image.h"

namespace dermis::environment {

/// Returns the mean over channels and sphere.
double mean_brightness(const image::ImageF& picture);

/// A connected set of pixels, all brighter (mean of the channels) than `level`.
struct LevelRegion {
  std::vector<std::uint32_t> pixels;  ///< y * width + x
  glm::dvec3 level{0};  ///< of its rim: the pixel where it joins a larger region, or the mean of the picture
  double excess = 0;    ///< Int (brightness - brightness of the level) dOmega
};

/// Returns the largest compact regions of three sizes: narrow ones first (they lie within wide ones, as a sun
/// in its glare), then by excess, largest first. Regions of one size do not overlap. Leaves out regions with
/// less than `least_excess`, and all that is no brighter than the mean of the picture.
std::vector<LevelRegion> compact_regions(const image::ImageF& picture, double least_excess);

}  // namespace dermis::environment
