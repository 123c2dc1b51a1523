// SPDX-License-Identifier: MIT
/// Takes suns, bulbs and windows out of a picture of the environment: regions so bright and so narrow that
/// they cast shadows and that harmonics of order 5 would ring. They become lights of their own.
/// Based on: Salembier, Oliveras, Garrido: Antiextensive Connected Operators for Image and Sequence
///           Processing. IEEE Transactions on Image Processing 7(4), 1998 (the tree of level sets)
#pragma once

#include <glm/glm.hpp>
#include <span>
#include <vector>

#include "environment/environment.h"
#include "environment/harmonics.h"

namespace dermis::environment {

/// A distant disc that sends the light of one region.
struct Source {
  glm::dvec3 direction{0};   ///< unit, towards the disc
  glm::dvec3 irradiance{0};  ///< on a surface that faces it: Int excess radiance dOmega, linear Rec.709
  double tangent = 0;        ///< of its angular radius
};

inline constexpr std::size_t most_sources = 8;

/// remainder + sources = the picture: their sum has the energy of the picture in each channel, up to the
/// rounding of floats.
struct Split {
  Environment remainder;        ///< the picture, each source cut off at the level around it
  std::vector<Source> sources;  ///< brightest first, at most `most_sources`
};

/// Splits a picture. A smooth or uniform picture has no sources and is its own remainder. No pixel of the
/// remainder is brighter than before, and none is below 0. A picture wider than 2048 is downsampled first by
/// a whole factor that divides both sides, if there is one; its energy stays.
Split split_sources(const Environment& picture);

/// Returns the harmonics of a sky and of its sources together, which is how occluders see them. Not windowed:
/// up to order 3 a facing surface has 1.06 of the light of a source, and one that faces away -0.04 at least.
/// A window without such values leaves 0.58 of it.
SkyHarmonics with_sources(SkyHarmonics sky, std::span<const Source> sources);

/// Returns the solid angle [sr] of one pixel of a row as radiance_at() interpolates it. All pixels of a
/// picture have 4 pi together.
double pixel_solid_angle(int row, int width, int height);

}  // namespace dermis::environment
