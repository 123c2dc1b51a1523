// SPDX-License-Identifier: MIT
/// Converts a skin material's height map to a normal map that includes the material's own normals.
#pragma once

#include <optional>
#include <vector>

#include "head/scene/asset_data.h"
#include "head/scene/surface/unwrap.h"
#include "image/image.h"

namespace dermis::scene {

/// Returns the map, to be read where the height map is read, with scale 1; nothing if the material has no
/// height map. `scene` has its skin.
std::optional<image::Image8> fine_normals(const AssetData& scene, std::size_t material);

}  // namespace dermis::scene
