// SPDX-License-Identifier: MIT
/// Cameras and lights at the nodes of an asset.
#pragma once

#include <glm/glm.hpp>

#include "head/scene/asset_data.h"

namespace dermis::scene {

/// Puts it where its node stands; scale and shear of the node are left out, and it looks, or shines, along
/// the node's -Z. `world`: from the node, m.
void stand_at(const glm::dmat4& world, Camera& camera);
void stand_at(const glm::dmat4& world, Light& light);

}  // namespace dermis::scene
