// SPDX-License-Identifier: MIT
// The alpha test of glTF at a point, at the full resolution of the map.
#pragma once

#include "rays/surface_point.h"

namespace dermis::rays {

/// Returns whether the material's alpha mode is mask and its alpha at the point is below the cutoff.
bool is_cut_away(const scene::AssetData& scene, const SurfacePoint& s);

}  // namespace dermis::rays
