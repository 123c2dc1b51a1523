// SPDX-License-Identifier: MIT
// Triangles that may be seen although all around them is not: on coarse meshes a triangle faces elsewhere
// than its vertices' normals say.
#pragma once

#include <cstdint>
#include <vector>

#include "scene/unwrap.h"

namespace dermis::scene {

inline constexpr std::uint32_t always_kept = 0xffffffffu;

/// For each triangle, those that touch it at a vertex, across seams too, and are turned away from one of
/// their vertices' normals by more than 14 degrees. Where a triangle is culled only if its vertices' normals
/// are beyond 105 degrees from the eye and it faces away, no other can be seen beside a culled one. Packed:
/// the entries of triangle t are [packed[t], packed[t + 1]) of `packed` itself; sorted, none twice. A
/// triangle that meets more than 64 turned ones at a vertex has the one entry `always_kept` instead.
std::vector<std::uint32_t> turned_neighbours(const SkinMesh& mesh);

}  // namespace dermis::scene
