// SPDX-License-Identifier: MIT
// Small generated scenes with one skin material: closed-form ground for tests and benchmarks. No lights, no
// cameras, no maps.
#pragma once

#include <glm/glm.hpp>

#include "scene/scene.h"

namespace dermis::scene {

/// Square in the xy plane, facing +Z, centred at the origin, side `size_m` (> 0), cells x cells quads.
/// Texture coordinates uv = uv_transform * (x / size + 1/2, 1/2 - y / size) + uv_offset: the identity covers
/// 0..1 with v down. Columns of uv_transform are what becomes of u and of v: mat2(1/3, 0, 0, 1) is stretched
/// 3:1, mat2(0.5, 0, 0.5, 0.5) sheared by 45 degrees. A mirrored one is allowed.
Scene plane(double size_m, const glm::dmat2& uv_transform = glm::dmat2(1), const glm::dvec2& uv_offset = {},
            int cells = 1);

/// Cube sphere around the origin: six charts of subdivisions x subdivisions quads, packed 3 x 2 into 0..1,
/// `margin` (texture coordinates) around each, so 2 * margin between two of them. Positions agree bit for bit
/// where charts meet; normals are exact. Directions are spaced by equal angles, which keeps the stretch
/// within a factor of 1.5.
Scene sphere(double radius_m, int subdivisions = 32, double margin = 0.02);

/// The same with three half axes; normals are those of the ellipsoid.
Scene ellipsoid(const glm::dvec3& radii_m, int subdivisions = 32, double margin = 0.02);

}  // namespace dermis::scene
