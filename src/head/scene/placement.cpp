// SPDX-License-Identifier: MIT
#include "head/scene/placement.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace dermis::scene {
namespace {

glm::vec3 unit_or(const glm::dvec3& v, const glm::dvec3& otherwise) {
  const double length = glm::length(v);
  return glm::vec3(length > 1e-30 && std::isfinite(length) ? v / length : otherwise);
}

}  // namespace

glm::dmat3 normal_matrix(const Placement& placement) {
  const glm::dvec3 x(placement.world_from_mesh[0]), y(placement.world_from_mesh[1]),
      z(placement.world_from_mesh[2]);
  // Cofactors are |M| M^-T without division by |M|. Its sign is removed, so that normals keep pointing
  // outwards under a mirror.
  glm::dmat3 cofactors(glm::cross(y, z), glm::cross(z, x), glm::cross(x, y));
  if (placement.mirrored) cofactors = -cofactors;

  double largest = 0;
  for (glm::length_t c = 0; c < 3; ++c)
    for (glm::length_t r = 0; r < 3; ++r) largest = std::max(largest, std::abs(cofactors[c][r]));
  return largest > 0 ? cofactors / largest : glm::dmat3(0);
}

glm::vec3 world_position_m(const Primitive& primitive, std::size_t copy, std::uint32_t vertex) {
  const glm::vec3& p = primitive.vertices[vertex].position_m;
  if (primitive.placements.empty()) return p;
  return glm::vec3(primitive.placements[copy].world_from_mesh * glm::dvec4(p, 1));
}

Vertex world_vertex(const Primitive& primitive, std::size_t copy, std::uint32_t vertex) {
  Vertex v = primitive.vertices[vertex];
  if (primitive.placements.empty()) return v;
  const Placement& placement = primitive.placements[copy];
  v.position_m = world_position_m(primitive, copy, vertex);
  v.normal = unit_or(normal_matrix(placement) * glm::dvec3(v.normal), {0, 0, 1});

  const glm::dvec3 n(v.normal), t = glm::dmat3(placement.world_from_mesh) * glm::dvec3(v.tangent);
  const glm::dvec3 any = std::abs(n.x) < 0.9 ? glm::dvec3(1, 0, 0) : glm::dvec3(0, 1, 0);
  const glm::vec3 across = unit_or(t - n * glm::dot(n, t), glm::normalize(any - n * glm::dot(n, any)));
  v.tangent = glm::vec4(across, placement.mirrored ? -v.tangent.w : v.tangent.w);
  return v;
}

std::array<std::uint32_t, 3> world_corners(const Primitive& primitive, std::size_t copy,
                                           std::size_t triangle) {
  const std::uint32_t* index = &primitive.indices[3 * triangle];
  const bool mirrored = !primitive.placements.empty() && primitive.placements[copy].mirrored;
  if (mirrored) return {index[0], index[2], index[1]};
  return {index[0], index[1], index[2]};
}

}  // namespace dermis::scene
