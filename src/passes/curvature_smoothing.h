// SPDX-License-Identifier: MIT
// How smooth the curvature of a mesh is: passes/curvature.
#pragma once

#include "scene/unwrap.h"

namespace dermis::passes {

/// Returns how often neighbours are averaged, 2 to 64: until curvature is smooth over a sigma of 1.5 mm of
/// the asset, which is finer than what light that scatters in red sees. Each time adds a quarter of the
/// squared length of an edge to the variance.
int curvature_smoothing(const scene::SkinMesh& mesh, double mm_per_unit);

}  // namespace dermis::passes
