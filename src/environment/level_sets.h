// SPDX-License-Identifier: MIT
/// Regions of a picture that are brighter than all that lies around them, and small on the sphere.
#pragma once

#include <cstdint>
#include <glm/glm.hpp>
#include <vector>

#include "image/image.h"

namespace dermis::environment {

/// Mean of the channels, over the sphere.
double mean_brightness(const image::ImageF& picture);

/// A connected set of pixels, all brighter (mean of the channels) than `level`.
struct LevelRegion {
  std::vector<std::uint32_t> pixels;  ///< y * width + x
  glm::dvec3 level{0};                ///< of its rim: the pixel where it would flow out, or the mean of all
  double excess = 0;                  ///< Int (brightness - that of the level) dOmega
};

/// The largest compact regions of three sizes, the narrow ones (which lie in the wide ones, as a sun in its
/// glare) first, of one size the strongest first. Those of one size do not overlap. Those with an excess
/// below `least_excess` are left out, and so is what is no brighter than the mean of the picture.
std::vector<LevelRegion> compact_regions(const image::ImageF& picture, double least_excess);

}  // namespace dermis::environment
