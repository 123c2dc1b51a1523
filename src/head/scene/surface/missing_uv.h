// SPDX-License-Identifier: MIT
// Handles maps whose texture coordinates a mesh lacks. glTF calls such a file an error; as other viewers do,
// we leave out these maps for that mesh.
#pragma once

#include <array>
#include <string>
#include <vector>

#include "head/scene/asset_data.h"

namespace dermis::scene {

/// Gives each primitive that lacks coordinates for a map of its material a copy of the material without such
/// maps, so that light map, picture and reference agree. `has_uv`: per primitive, which sets of coordinates
/// it has. Changes materials or appends to them. Warns, once per kind; `file` is for messages.
void leave_out_maps_without_uv(const std::string& file, const std::vector<std::array<bool, 2>>& has_uv,
                               AssetData& scene);

}  // namespace dermis::scene
