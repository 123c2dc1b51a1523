// SPDX-License-Identifier: MIT
/// Draws skin whose light has been blurred.
#pragma once

#include <vector>

#include "render/techniques/texture_space/light_maps.h"

namespace dermis::techniques {

/// Adds up the blurred light of each square, for a host that reads it. `squares`: as of add_final().
void add_scatter_sum(passes::FramePlan& plan, const FrameSettings& settings, const LightMaps& maps,
                     frame::TextureId sum, const std::vector<passes::MapSquare>& squares);

/// Shades skin meshes of heads: the weighted sum of the blurred maps times the albedo, plus what the surface
/// reflects. Before, counts the texels that this reads though they were never lit. `squares`: of one batch,
/// sorted by mesh, on squares of the pool.
void add_final(const FrameSettings& settings, Screen& screen, const LightMaps& maps,
               const std::vector<passes::MapSquare>& squares);

}  // namespace dermis::techniques
