// SPDX-License-Identifier: MIT
// Primitives as they stand in the world, whether they stand there once or share their mesh with other nodes.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <glm/glm.hpp>

#include "head/scene/asset_data.h"

namespace dermis::scene {

/// Returns the number of copies of the primitive in the world; at least 1.
inline std::size_t copies_of(const Primitive& primitive) {
  return primitive.placements.empty() ? 1 : primitive.placements.size();
}

/// Returns the matrix for normals: the inverse transpose up to a positive factor, its largest entry 1. Valid
/// for flat (singular) matrices; zero if nothing is left of the mesh.
glm::dmat3 normal_matrix(const Placement& placement);

/// Returns vertex `vertex` of copy `copy` (below copies_of) in the world. Normal and tangent are unit.
Vertex world_vertex(const Primitive& primitive, std::size_t copy, std::uint32_t vertex);
glm::vec3 world_position_m(const Primitive& primitive, std::size_t copy, std::uint32_t vertex);

/// Returns the vertices of a triangle of copy `copy`, counter-clockwise in the world.
std::array<std::uint32_t, 3> world_corners(const Primitive& primitive, std::size_t copy,
                                           std::size_t triangle);

/// Calls visit(position in the world, m) for every vertex of every copy.
template <class Visit>
void for_each_position(const Primitive& primitive, const Visit& visit) {
  for (std::size_t copy = 0; copy < copies_of(primitive); ++copy)
    for (std::uint32_t v = 0; v < primitive.vertices.size(); ++v) visit(world_position_m(primitive, copy, v));
}

}  // namespace dermis::scene
