// SPDX-License-Identifier: MIT
// Where skin ends: at the neck, around the eyes, at the lips of an open mouth.
#pragma once

#include <vector>

#include "head/scene/surface/unwrap.h"

namespace dermis::scene {

/// Returns, per vertex, the length of the shortest way along edges to an open border of the mesh
/// (Topology::mate), in mm, at most `most_mm` (>= 0). Seams of the unwrap are no border. O(n log n).
std::vector<float> border_distances_mm(const SkinMesh& mesh, double mm_per_unit, float most_mm);

}  // namespace dermis::scene
