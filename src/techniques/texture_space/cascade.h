// SPDX-License-Identifier: MIT
/// Spreads the light of a skin mesh by its profile from wide to narrow: passes/cascade/.
#pragma once

#include <vector>

#include "techniques/cascade_plan.h"
#include "techniques/texture_space/light_maps.h"

namespace dermis::techniques {

/// Adds the cascade of one skin mesh, up to the map of the sum. `squares`: those of `mesh`, on maps of T_max.
void add_cascade(passes::FramePlan& plan, const FrameSettings& settings, LightMaps& maps, std::uint32_t mesh,
                 const std::vector<passes::MapSquare>& squares);

}  // namespace dermis::techniques
