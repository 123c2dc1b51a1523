// SPDX-License-Identifier: MIT
// Where the texture coordinates of a head lie on its light map: one scale and one offset for the mesh, and
// which triangles the map cannot hold.
#pragma once

#include <vector>

#include "scene/unwrap.h"

namespace dermis::scene {

/// Fills unwrap, unwrap_scale, unwrap_offset and unwrap_note from the raw coordinates uv0 of the vertices and
/// returns, per triangle, whether it lies on the map. Left off it are
/// - triangles whose raw coordinates are not finite, have no area (see uv_area2) or lie nearly on a line, as
///   they do not on the skin;
/// - strays: few triangles whose coordinates lie so far from all others that with them the rest would get a
///   fraction of its texels. At most 1 % of the skin's area on each side of an axis if that makes the others
///   at least 4 times as large, 5 % for 16 times, 25 % for 64 times.
///
/// Of the rest, coordinates within 0..1 are used as they are, or moved by whole tiles if that brings them
/// there. If that is not enough, or if their box then covers less than a quarter of the square, they are
/// fitted by one scale and offset per axis. A box that is small in one direction alone grows there until a
/// mm of skin has, in the mean, twice as many texels along this axis as along the other; more would only
/// cost. Grown boxes keep `fit_margin` free on all sides for their gutters. Warns where the map then holds
/// clearly fewer texels per mm than the raw coordinates would without limits, and of strays.
std::vector<bool> fit_unwrap(SkinMesh& mesh);

/// of the square's side
inline constexpr double fit_margin = 1.0 / 64;

}  // namespace dermis::scene
