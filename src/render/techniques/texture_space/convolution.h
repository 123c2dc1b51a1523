// SPDX-License-Identifier: MIT
/// Spreads the light of skin meshes by their profiles, term after term.
#pragma once

#include <vector>

#include "render/techniques/texture_space/light_maps.h"

namespace dermis::techniques {

/// Adds the blurs of the skin meshes of a batch. `squares`: of the pool, sorted by mesh. Meshes go through
/// each step together; profiles that have more steps than others take further ones.
///
/// Up to two terms start from the light: direct_steps(). Blurring a blurred map adds variances, so each
/// further term starts from the one before, narrow to wide. Gutters at seams are refreshed after each step.
void add_convolution(passes::FramePlan& plan, const FrameSettings& settings, LightMaps& maps,
                     const std::vector<passes::MapSquare>& squares);

}  // namespace dermis::techniques
