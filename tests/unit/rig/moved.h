// SPDX-License-Identifier: MIT
// How far moved vertices are from where they should be.
#pragma once

#include <vector>

#include "../gltf/posed_by_hand.h"
#include "head/scene/asset_data.h"

namespace dermis::scene::test {

using Points = std::vector<std::vector<PosedByHand::Point>>;

struct Compared {
  double farthest = 0, size = 0;  ///< m
};

/// Compares a scene with the positions of its vertices by hand, but for meshes that stand at several places.
Compared compare(const AssetData& scene, const Points& expected);

/// Largest differences of positions (m) and of directions.
struct Apart {
  double positions = 0, normals = 0, tangents = 0;
};
Apart apart(const AssetData& a, const AssetData& b);

}  // namespace dermis::scene::test
