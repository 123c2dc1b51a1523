// SPDX-License-Identifier: MIT
// Smoothness of the curvature of a mesh: render/passes/pose/curvature.
#pragma once

#include "head/scene/surface/unwrap.h"

namespace dermis::passes {

/// Returns how often neighbours are averaged, 2 to 64: until curvature is smooth over a sigma of 1.5 mm of
/// the asset. Red light scatters further than that. Each time adds a quarter of the squared length of an edge
/// to the variance.
int curvature_smoothing(const scene::SkinMesh& mesh, double mm_per_unit);

}  // namespace dermis::passes
