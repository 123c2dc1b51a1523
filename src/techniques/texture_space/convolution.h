// SPDX-License-Identifier: MIT
/// Spreads the light of a skin mesh by its profile, term after term.
#pragma once

#include <vector>

#include "techniques/texture_space/light_maps.h"

namespace dermis::techniques {

/// Adds the blurs of one skin mesh. `squares`: those of `mesh`, on maps of T_max.
///
/// Gaussians compose: blurring a blurred map adds variances, so each term starts from the one before, narrow
/// to wide. Gutters at seams are refreshed after each step.
void add_convolution(passes::FramePlan& plan, const FrameSettings& settings, LightMaps& maps,
                     std::uint32_t mesh, const std::vector<passes::MapSquare>& squares);

}  // namespace dermis::techniques
