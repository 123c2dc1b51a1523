// SPDX-License-Identifier: MIT
// Scenes whose answer is known.
#pragma once

#include "head/scene/asset_data.h"
#include "support/scenes.h"
#include "truth/reference/render.h"

namespace dermis::tests {

/// A closed box of skin: its top is z = 0, seen from +z; `depth_mm` deep, `half_mm` to each side.
scene::AssetData box(double depth_mm, double half_mm);

/// Uniform light from everywhere, white skin, framed; nothing else.
reference::Job furnace(const scene::AssetData& scene, int side);

/// `samples` of every pixel.
reference::Film rendered(const reference::Tracer& tracer, std::uint32_t samples, std::uint64_t seed = 1,
                         int threads = 0);

}  // namespace dermis::tests
