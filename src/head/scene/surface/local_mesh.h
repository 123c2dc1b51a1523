// SPDX-License-Identifier: MIT
// One primitive of a mesh in its own coordinates, as a file or a host gives it: triangles and attributes as
// float arrays, before they become vertices in the world. The steps that every source of meshes shares.
#pragma once

#include <array>
#include <cstdint>
#include <glm/glm.hpp>
#include <span>
#include <string_view>
#include <vector>

#include "head/scene/asset_data.h"

namespace dermis::scene {

/// Arrays hold `vertices` times their number of components; an absent attribute is empty. Every index is
/// below `vertices`, every vertex is used, and all numbers but normals and tangents are finite.
struct LocalMesh {
  std::size_t vertices = 0;
  std::vector<std::uint32_t> indices;  ///< triangles
  /// number in its source of each vertex; empty: the same as here
  std::vector<std::uint32_t> original;
  std::vector<float> positions, normals, tangents;    ///< 3, 3, 4 each
  std::array<std::vector<float>, 2> uvs;              ///< 2 each
  std::vector<float> colours;                         ///< 4 each
  std::array<std::vector<float>, 2> joints, weights;  ///< 4 each
};

/// A place of a mesh in the world.
struct Frame {
  glm::dmat4 matrix{1};
  /// inverse transpose up to a positive factor; valid for flat (singular) matrices
  glm::dmat3 normal_matrix{1};
  bool mirrored = false;
};
Frame frame_of(const glm::dmat4& matrix);

/// Place that errors name: the file, and the mesh in it.
struct MeshPlace {
  std::string_view file, mesh;
};

/// Throws InputError for the first index that is not below `vertices`.
void check_indices(const MeshPlace& place, std::span<const std::uint32_t> indices, std::size_t vertices);
/// Throws InputError for the first number that is not finite; `name` is the attribute's.
void check_finite(const MeshPlace& place, std::string_view name, std::span<const float> values,
                  int components);
/// Throws InputError if vertex i lies too far out.
void check_position(const MeshPlace& place, const glm::vec3& position_m, std::size_t i);
void check_coordinates(const MeshPlace& place, const glm::vec2& uv, std::size_t i);

/// Returns the vertices that triangles use, in their order; empty if all are used. Renumbers the indices,
/// which are all below `vertices`.
std::vector<std::uint32_t> drop_unused(std::vector<std::uint32_t>& indices, std::size_t vertices);

/// Returns vertex i in the world, without a normal or a tangent where they have no direction. Checks nothing.
Vertex place_vertex(const LocalMesh& mesh, std::size_t i, const Frame& frame);

/// Returns whether the source's tangents are usable: with normals, a direction and a handedness.
bool usable_tangents(const LocalMesh& mesh, const std::vector<Vertex>& placed);

}  // namespace dermis::scene
