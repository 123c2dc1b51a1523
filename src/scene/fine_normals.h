// SPDX-License-Identifier: MIT
/// Pores without triangles: a skin material's height map, turned into a normal map that holds the material's
/// own normals too.
#pragma once

#include <optional>
#include <vector>

#include "image/image.h"
#include "scene/scene.h"
#include "scene/unwrap.h"

namespace dermis::scene {

/// None if the material has no height map. The result is read where the height map is read, with scale 1.
std::optional<image::Image8> fine_normals(const Scene& scene, std::size_t material,
                                          const std::vector<SkinMesh>& skin);

}  // namespace dermis::scene
