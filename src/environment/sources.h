// SPDX-License-Identifier: MIT
/// Suns, bulbs, windows: what of a picture of the surroundings is so bright and so narrow that it casts
/// shadows, and that harmonics of order 5 would ring. Such sources are taken out of the picture and light as
/// the lamps that they are. Based on: Salembier, Oliveras, Garrido: Antiextensive Connected Operators for
/// Image and Sequence Processing. IEEE Transactions on Image Processing 7(4), 1998 (the tree of level sets)
#pragma once

#include <glm/glm.hpp>
#include <vector>

#include "environment/environment.h"

namespace dermis::environment {

/// A disc far away that sends its light alone.
struct Source {
  glm::dvec3 direction{0};   ///< unit, towards it
  glm::dvec3 irradiance{0};  ///< on a surface that faces it: Int excess radiance dOmega, linear Rec.709
  double tangent = 0;        ///< of half the angle under which it is seen
};

inline constexpr std::size_t most_sources = 8;

/// remainder + sources = the picture: their energy is the same in each channel but for the rounding of
/// floats.
struct Split {
  Environment remainder;        ///< the picture, each source cut off at the level of what lies around it
  std::vector<Source> sources;  ///< brightest first, at most `most_sources`
};

/// Takes the compact sources out. A smooth or uniform picture has none, and is its own remainder. No pixel of
/// the remainder is brighter than it was, and none below 0. A picture wider than 2048 is made smaller first,
/// by a whole factor that divides both sides, if there is one; its energy stays.
Split split_sources(const Environment& picture);

/// Int dOmega of what bilinear reading makes of one pixel of a row, as radiance_at() does it: sr. All pixels
/// of a picture have 4 pi together.
double pixel_solid_angle(int row, int width, int height);

}  // namespace dermis::environment
