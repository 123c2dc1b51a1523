// SPDX-License-Identifier: MIT
// Finds triangles that may be visible although all around them are culled: on coarse meshes a triangle may
// face another way than its vertex normals.
#pragma once

#include <cstdint>
#include <vector>

#include "head/scene/surface/unwrap.h"

namespace dermis::scene {

inline constexpr std::uint32_t always_kept = 0xffffffffu;

/// Returns, for each triangle, the triangles that touch it at a vertex, also across seams, and whose face
/// normal is more than 14 degrees away from one of their vertex normals. A triangle is culled only if its
/// vertex normals are more than 105 degrees from the eye and it faces away, so no other triangle can be
/// visible beside a culled one.
///
/// Packed: the entries of triangle t are [packed[t], packed[t + 1]) of `packed` itself; sorted, none twice. A
/// triangle that meets more than 64 such triangles at a vertex has the one entry `always_kept` instead.
std::vector<std::uint32_t> turned_neighbours(const SkinMesh& mesh);

/// Returns, packed likewise, all triangles that touch each triangle: whatever shape the mesh takes, those of
/// turned_neighbours() are among them.
std::vector<std::uint32_t> touching_neighbours(const SkinMesh& mesh);

}  // namespace dermis::scene
