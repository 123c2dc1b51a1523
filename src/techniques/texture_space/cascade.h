// SPDX-License-Identifier: MIT
/// Spreads the light of skin meshes by their profiles from wide to narrow: passes/cascade/.
#pragma once

#include <vector>

#include "techniques/cascade_plan.h"
#include "techniques/texture_space/light_maps.h"

namespace dermis::techniques {

/// Adds the cascades of the skin meshes of a batch, up to the map of the sum. `squares`: on maps of T_max,
/// sorted by mesh. Meshes go through each step together; profiles that have more steps than others take
/// further ones.
void add_cascade(passes::FramePlan& plan, const FrameSettings& settings, LightMaps& maps,
                 const std::vector<passes::MapSquare>& squares);

}  // namespace dermis::techniques
