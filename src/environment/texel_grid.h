// SPDX-License-Identifier: MIT
// Points of a skin mesh on the centres of the texels of a map over its unwrap.
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "head/scene/surface/unwrap.h"

namespace dermis::environment {

struct GridTexel {
  std::uint32_t triangle = ~0u;
  float u = 0, v = 0;  // weights of the second and third corner
  bool covered() const { return triangle != ~0u; }
};

struct TexelGrid {
  int side;
  std::vector<GridTexel> texels;  // rows from top to bottom
  std::size_t at(int x, int y) const {
    return static_cast<std::size_t>(y) * static_cast<std::size_t>(side) + static_cast<std::size_t>(x);
  }
};

TexelGrid rasterise(const scene::SkinMesh& mesh, int side);

/// Texels off the mesh that repeat their neighbours: more than bilinear filtering ever reads beside a seam.
inline constexpr int dilation = 6;

/// Returns the grid with the point of a neighbour on each texel that repeats its neighbours.
TexelGrid dilated(const TexelGrid& grid);

}  // namespace dermis::environment
