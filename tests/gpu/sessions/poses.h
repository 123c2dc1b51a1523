// SPDX-License-Identifier: MIT
// Transforms of instances, column-major.
#pragma once

#include <array>
#include <cmath>
#include <glm/glm.hpp>

namespace dermis::tests {

/// Turned about +Y, then shifted along +X.
inline std::array<double, 16> turned(double angle_rad, double shift_m) {
  const double c = std::cos(angle_rad), s = std::sin(angle_rad);
  return {c, 0, -s, 0, 0, 1, 0, 0, s, 0, c, 0, shift_m, 0, 0, 1};
}

inline std::array<double, 16> moved(const glm::dvec3& by_m) {
  return {1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, by_m.x, by_m.y, by_m.z, 1};
}

}  // namespace dermis::tests
