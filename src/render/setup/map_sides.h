// SPDX-License-Identifier: MIT
/// The sides of the light maps of a frame.
#pragma once

#include <cstdint>
#include <vector>

#include "render/setup/frame_setup.h"

namespace dermis::setup {

/// Returns the sides of light maps that a head of the scene may have, large to small, texels.
std::vector<std::uint32_t> map_sides(const techniques::FrameSettings& plan, const RenderSettings& settings);

/// Decides T of each head, at most T_max of its model.
void set_head_sides(FrameSetup& setup, const PlacedScene& scene, const RenderSettings& settings);

/// Decides how large light maps are: T_max of the plan, and T of each head. `every_view`: see set_up().
void set_up_map_sides(FrameSetup& setup, const PlacedScene& scene, const RenderSettings& settings,
                      bool every_view);

}  // namespace dermis::setup
