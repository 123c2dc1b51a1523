// SPDX-License-Identifier: MIT
// A scene without shared meshes.
#pragma once

#include <algorithm>
#include <array>
#include <cstdint>
#include <vector>

#include "head/scene/placement.h"

namespace dermis::scene {

/// Returns the primitives with every copy written out, in the order of their nodes' first appearance.
inline std::vector<Primitive> written_out(const AssetData& scene) {
  std::vector<Primitive> all;
  for (const Primitive& primitive : scene.primitives)
    for (std::size_t copy = 0; copy < copies_of(primitive); ++copy) {
      Primitive& out = all.emplace_back(primitive);
      out.placements.clear();
      if (primitive.placements.empty()) continue;
      out.node = primitive.placements[copy].node;
      for (std::uint32_t v = 0; v < out.vertices.size(); ++v)
        out.vertices[v] = world_vertex(primitive, copy, v);
      for (std::size_t t = 0; t < out.indices.size() / 3; ++t) {
        const std::array<std::uint32_t, 3> corners = world_corners(primitive, copy, t);
        std::copy(corners.begin(), corners.end(), out.indices.begin() + static_cast<std::ptrdiff_t>(3 * t));
      }
    }
  return all;
}

}  // namespace dermis::scene
