// SPDX-License-Identifier: MIT
/// Draws skin whose light has been blurred.
#pragma once

#include "techniques/texture_space/light_maps.h"

namespace dermis::techniques {

/// The sum of the blurred maps times the albedo, plus what the surface reflects, on the screen; and counts
/// the texels that are read without having been lit.
void add_final(passes::FramePlan& plan, const FrameSettings& settings, Screen& screen, const LightMaps& maps,
               const passes::MapSquare& square);

}  // namespace dermis::techniques
