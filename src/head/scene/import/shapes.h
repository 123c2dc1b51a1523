// SPDX-License-Identifier: MIT
// Generates small scenes with one skin material and closed forms, for tests and benchmarks. No lights,
// cameras or maps.
#pragma once

#include <glm/glm.hpp>

#include "head/scene/asset_data.h"

namespace dermis::scene {

/// Returns a square in the xy plane, facing +Z, centred at the origin, side `size_m` (> 0), of cells x cells
/// quads. Texture coordinates uv = uv_transform * (x / size + 1/2, 1/2 - y / size) + uv_offset: the identity
/// covers 0..1 with v down. Columns of uv_transform are the images of u and v: mat2(1/3, 0, 0, 1) stretches
/// 3:1, mat2(0.5, 0, 0.5, 0.5) shears by 45 degrees. It may mirror.
AssetData plane(double size_m, const glm::dmat2& uv_transform = glm::dmat2(1),
                const glm::dvec2& uv_offset = {}, int cells = 1);

/// Returns a cube sphere around the origin: six charts of subdivisions x subdivisions quads, packed 3 x 2
/// into 0..1 with `margin` (texture coordinates) around each, so 2 * margin between two. Positions are equal
/// to the bit where charts meet; normals are exact. Directions are spaced by equal angles, which keeps the
/// stretch within a factor of 1.5.
AssetData sphere(double radius_m, int subdivisions = 32, double margin = 0.02);

/// Returns the same with three half axes and the normals of the ellipsoid.
AssetData ellipsoid(const glm::dvec3& radii_m, int subdivisions = 32, double margin = 0.02);

}  // namespace dermis::scene
