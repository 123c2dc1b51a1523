// SPDX-License-Identifier: MIT
// A point of a surface: the vertex attributes of its triangle, interpolated.
#pragma once

#include <array>
#include <glm/glm.hpp>

#include "rays/ray_scene.h"

namespace dermis::rays {

struct SurfacePoint {
  glm::dvec3 position_m{0};
  glm::dvec3 shadow_origin_m{0};    ///< start of rays to the lights
  glm::dvec3 normal{0, 0, 1};       ///< interpolated, unit, on the front side
  glm::dvec3 face_normal{0, 0, 1};  ///< of the triangle, unit, on the front side
  glm::dvec4 tangent{1, 0, 0, 1};
  std::array<glm::dvec2, 2> uv{};
  glm::dvec4 colour{1};
  std::size_t material = 0;
};

SurfacePoint surface_point(const scene::AssetData& scene, const Hit& hit);

}  // namespace dermis::rays
