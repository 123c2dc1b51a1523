// SPDX-License-Identifier: MIT
// Welds vertices that exporters have split (seams, materials, quantisation).
#pragma once

#include <cstdint>
#include <glm/glm.hpp>
#include <span>
#include <vector>

#include "head/scene/asset_data.h"

namespace dermis::scene {

/// Returns one id per point, equal for points that agree in every component after rounding to multiples of
/// `grid` (> 0; non-finite components count as 0). Ids run from 0 to max in order of first appearance,
/// independent of hashing. O(n).
std::vector<std::uint32_t> weld_points(std::span<const glm::dvec3> points, double grid);

/// weld_points over positions, grid = 1e-6 of the largest extent: joins exact copies, and never distinct
/// points of a mesh.
std::vector<std::uint32_t> weld_positions(std::span<const Vertex> vertices);

/// weld_points over texture coordinates, grid 1e-6: 1/500 texel of a 2048 map, twenty times the rounding of a
/// float near 1.
std::vector<std::uint32_t> weld_uv(std::span<const glm::vec2> uv);

}  // namespace dermis::scene
