// SPDX-License-Identifier: MIT
// What of cut-out materials is there: the alpha test of glTF at a point, at the full resolution of its map.
#pragma once

#include "rays/surface_point.h"

namespace dermis::rays {

/// Is the material's alpha mode mask, and its alpha at the point under the cutoff?
bool is_cut_away(const scene::Scene& scene, const SurfacePoint& s);

}  // namespace dermis::rays
