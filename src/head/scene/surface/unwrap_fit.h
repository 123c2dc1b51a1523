// SPDX-License-Identifier: MIT
// Places the texture coordinates of a head on its light map: one scale and offset per axis for the mesh, and
// the triangles that the map cannot hold.
#pragma once

#include <vector>

#include "head/scene/surface/unwrap.h"

namespace dermis::scene {

/// Fills unwrap, unwrap_scale, unwrap_offset and unwrap_note from the raw coordinates uv0 of the vertices.
/// Returns, per triangle, whether it lies on the map. Left out are
/// - triangles whose raw coordinates are not finite, have no area (see uv_area2) or lie nearly on a line
///   although they have width on the skin;
/// - strays: few triangles so far from all others that the rest would get only a fraction of the texels. Per
///   side of an axis, at most 1 % of the skin's area if the rest becomes at least 4 times as large, 5 % for
///   16 times, 25 % for 64 times.
///
/// Coordinates of the rest within 0..1 are kept, or moved by whole tiles if that brings them there.
/// Otherwise, or if their box covers less than a quarter of the square, they are fitted by one scale and
/// offset per axis. A box that is small in one direction only grows there until a mm of skin has, on average,
/// twice as many texels along this axis as along the other. Grown boxes keep `fit_margin` free on all sides
/// for gutters. Warns if the map then holds clearly fewer texels per mm than the raw coordinates would, and
/// about strays.
std::vector<bool> fit_unwrap(SkinMesh& mesh);

/// of the square's side
inline constexpr double fit_margin = 1.0 / 64;

}  // namespace dermis::scene
