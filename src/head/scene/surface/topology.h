// SPDX-License-Identifier: MIT
// Connections of the triangles of a mesh: across edges, and in charts of the
// unwrap.
#pragma once

#include <cstdint>
#include <glm/glm.hpp>
#include <span>
#include <vector>

#include "head/scene/asset_data.h"

namespace dermis::scene {

inline constexpr std::uint32_t no_edge = 0xffffffffu;

/// Half edge 3 t + k runs from corner k to corner (k + 1) % 3 of triangle t: from index `half` of the mesh to
/// index next_corner(half).
inline std::uint32_t next_corner(std::uint32_t half) { return half % 3 == 2 ? half - 2 : half + 1; }

/// Connections of the half edges of a mesh.
struct Topology {
  std::vector<std::uint32_t> position_id;  ///< per vertex; equal = same place (weld_positions)
  std::vector<std::uint32_t> uv_id;        ///< per vertex; equal = same texture coordinates (weld_uv)
  /// per half edge: the half edge of the neighbour at the same place, no_edge at an open border
  std::vector<std::uint32_t> mate;
  /// per half edge: the unwrap continues across it (same coordinates, neighbour on the other side)
  std::vector<bool> continuous;
};

/// Returns the topology of a mesh: indices.size() is a multiple of 3, all < vertices.size() == uv.size(). Of
/// more than two triangles at an edge, pairs those first that share coordinates. O(n log n).
Topology mesh_topology(std::span<const Vertex> vertices, std::span<const glm::vec2> uv,
                       std::span<const std::uint32_t> indices);

/// Returns twice the signed area of a triangle in texture space; 0 if it is smaller than the rounding of its
/// coordinates.
double uv_area2(const glm::vec2& a, const glm::vec2& b, const glm::vec2& c);

/// Returns the chart of each triangle, from 0 in order of first appearance: triangles joined by continuous
/// edges. A triangle without area in texture space never joins two charts. It takes the chart of the first
/// neighbour that shares coordinates with it, else it is a chart of its own.
std::vector<std::uint32_t> find_charts(const Topology& topology, std::span<const glm::vec2> uv,
                                       std::span<const std::uint32_t> indices);

}  // namespace dermis::scene
