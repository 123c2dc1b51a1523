// SPDX-License-Identifier: MIT
// The volume of the head without neck, nose, lips, lids and ears: the smoothest star-shaped surface through a
// list of landmarks.
#pragma once

#include <array>
#include <vector>

#include "head/builtin_head/clay.h"

namespace dermis::builtin_head {

/// r(direction) about a centre: a cubic radial basis function interpolates the radii of the landmarks over
/// the sphere of directions (the least bending of all interpolants in space). A cube map of it makes it
/// cheap.
class Skull {
 public:
  Skull();
  /// Returns a signed value in mm, close to the distance near the surface.
  float operator()(const vec3& p) const;

 private:
  static constexpr int side = 40;   // cells per cube edge, 2.25 degrees: 3 mm on the skin
  static constexpr int margin = 2;  // so that cubic interpolation never leaves its face
  static constexpr int stride = side + 2 * margin + 1;
  float radius(const vec3& direction) const;
  std::array<std::vector<float>, 6> radii_;
};

}  // namespace dermis::builtin_head
