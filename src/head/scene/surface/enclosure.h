// SPDX-License-Identifier: MIT
// Encloses a shape in a convex body of few corners, for fits that are tighter than a sphere.
#pragma once

#include <glm/glm.hpp>
#include <span>
#include <vector>

#include "head/scene/asset_data.h"

namespace dermis::scene {

/// Returns the corners of the smallest body with faces in 50 fixed directions that holds all points, enlarged
/// by 1e-5 of its size against rounding. At most 96 or so; none if there is no point. Flat shapes have flat
/// bodies.
std::vector<glm::vec3> enclosing_corners(std::span<const glm::vec3> points_m);

/// Returns the enclosing_corners of all vertices of the primitives, in all their placements.
std::vector<glm::vec3> enclosing_corners(const AssetData& scene);

}  // namespace dermis::scene
