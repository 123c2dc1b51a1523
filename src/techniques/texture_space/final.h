// SPDX-License-Identifier: MIT
/// Draws skin whose light has been blurred.
#pragma once

#include "techniques/texture_space/light_maps.h"

namespace dermis::techniques {

/// Draws one skin mesh of one head: the weighted sum of the blurred maps times the albedo, plus what the
/// surface reflects. Then counts the texels that this reads though they were never lit.
/// Adds up the blurred light of one square for a host that reads it.
void add_scatter_sum(passes::FramePlan& plan, const FrameSettings& settings, const LightMaps& maps,
                     frame::TextureId sum, const passes::MapSquare& square);

void add_final(passes::FramePlan& plan, const FrameSettings& settings, Screen& screen, const LightMaps& maps,
               const passes::MapSquare& square);

}  // namespace dermis::techniques
