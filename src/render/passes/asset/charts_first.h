// SPDX-License-Identifier: MIT
// The order in which triangles of skin are drawn.
#pragma once

#include "head/scene/surface/unwrap.h"

namespace dermis::passes {

/// Returns the mesh with triangles that have a chart before those that have none, so that few draws hold each
/// kind. Vertices keep their numbers.
scene::SkinMesh charts_first(const scene::SkinMesh& skin);

}  // namespace dermis::passes
