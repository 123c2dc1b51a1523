// SPDX-License-Identifier: MIT
// Directions about an axis.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <glm/glm.hpp>

namespace dermis::reference {

/// Returns the unit axis and two directions perpendicular to it and to each other (Duff et al.: Building an
/// Orthonormal Basis, Revisited. JCGT 2017).
inline std::array<glm::dvec3, 3> axes_of(const glm::dvec3& n) {
  const double sign = std::copysign(1.0, n.z), a = -1 / (sign + n.z), b = n.x * n.y * a;
  return {n, glm::dvec3(1 + sign * n.x * n.x * a, sign * b, -sign * n.x),
          glm::dvec3(b, sign + n.y * n.y * a, -n.y)};
}

/// Returns the unit direction at this cosine to a unit axis, rotated about it by `angle_rad`.
inline glm::dvec3 around(const glm::dvec3& axis, double cosine, double angle_rad) {
  const std::array<glm::dvec3, 3> axes = axes_of(axis);
  const double sine = std::sqrt(std::max(0.0, 1 - cosine * cosine));
  return glm::normalize(sine * (std::cos(angle_rad) * axes[1] + std::sin(angle_rad) * axes[2]) +
                        cosine * axis);
}

}  // namespace dermis::reference
