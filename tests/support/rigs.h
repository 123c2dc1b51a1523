// SPDX-License-Identifier: MIT
// Scenes made in memory that can be posed. No device.
#pragma once

#include <functional>
#include <glm/glm.hpp>
#include <memory>

#include "head/scene/asset_data.h"
#include "head/scene/rig/rig.h"

namespace dermis::tests {

/// Returns a rig whose node 0 has one morph target, which moves each vertex of the scene's first primitive at
/// p by `moved(p)` minus p. Of the others, which have placements, each of these hangs on a node of its own:
/// 1, 2 ... The first primitive has no placements.
std::shared_ptr<const scene::Rig> morphing(const scene::AssetData& made,
                                           const std::function<glm::vec3(const glm::vec3&)>& moved);

}  // namespace dermis::tests
