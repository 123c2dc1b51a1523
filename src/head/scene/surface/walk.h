// SPDX-License-Identifier: MIT
// Follows straight lines on a triangle mesh: unfolds across edges and around vertices.
// Based on: [PS06] Polthier, Schmies: Straightest Geodesics on Polyhedral Surfaces. SIGGRAPH 2006 courses
// (here the line always starts at a given angle to one side, so it only leaves vertices and never crosses
// them).
#pragma once

#include <array>
#include <cstdint>
#include <glm/glm.hpp>
#include <optional>
#include <span>
#include <vector>

#include "head/scene/surface/topology.h"

namespace dermis::scene {

struct MeshPoint {
  std::uint32_t triangle = 0;
  glm::dvec3 barycentric{1, 0, 0};  ///< 0..1, sum 1
};

/// A mesh prepared for lines. Holds references: topology and indices must outlive it. Const functions may run
/// on many threads.
class Walker {
 public:
  Walker(const Topology& topology, std::span<const Vertex> vertices, std::span<const glm::vec2> uv,
         std::span<const std::uint32_t> indices);

  /// Leaves a triangle through its half edge at the point `along` (0 = start, 1 = end; exactly 0 or 1 turns
  /// around that vertex) and goes straight on by `uv_vector`. That is given in texture coordinates of the
  /// triangle, and converted to lengths in its plane. The line crosses to neighbours at the same place,
  /// whatever their coordinates. Returns nothing if it meets an open border or does not end within 1,000
  /// triangles.
  std::optional<MeshPoint> leave(std::uint32_t half, double along, const glm::dvec2& uv_vector) const;

 private:
  using Flat = std::array<glm::dvec2, 3>;  ///< a triangle laid in the plane, counter-clockwise
  struct State {
    std::uint32_t triangle;
    glm::dvec2 at, vector;  ///< in the triangle's plane
    unsigned closed_edges;  ///< bit k: the line does not leave through edge k, where it came in
  };

  std::uint32_t place(std::uint32_t half) const { return topology_.position_id[indices_[half]]; }
  std::optional<State> cross(std::uint32_t half, double along, const glm::dvec2& vector) const;
  std::optional<State> turn(std::uint32_t half, bool at_end, const glm::dvec2& vector) const;
  std::optional<MeshPoint> straight(State state) const;

  const Topology& topology_;
  std::span<const glm::vec2> uv_;
  std::span<const std::uint32_t> indices_;
  std::vector<Flat> flat_;
};

}  // namespace dermis::scene
