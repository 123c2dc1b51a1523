// SPDX-License-Identifier: MIT
// Makes gutters, so that blurred light crosses the seams of the unwrap: empty texels around each chart copy
// the skin that continues there.
#pragma once

#include <cstdint>
#include <vector>

#include "head/scene/surface/unwrap.h"

namespace dermis::scene {

/// One texel outside the charts, and the place on the map of the skin that continues there.
struct GutterTexel {
  std::uint16_t x = 0, y = 0;  ///< texel
  /// the chart that it extends (SkinMesh::triangle_chart); 0 = fill colour only, alpha stays 0
  std::uint16_t chart = 0;
  float source_x = 0, source_y = 0;  ///< texels, centres at .5; read bilinearly
};

/// Returns the gutters of a map of `side` x `side` texels (1 .. 16384), up to `width_texels` (>= 1) wide.
///
/// Lists all texels whose centre no triangle covers (the rule of rasterisers, coverage.h) or lies within
/// 1/256 texel of a chart's border, where devices may differ: write gutters after rasterising. Each texel
/// belongs to the nearest border edge, Euclidean in texels; at equal distance to the edge whose normal is
/// closer to its direction; then to the first.
/// - Border with a partner (the neighbour at the same place lies elsewhere on the map): unfolds the owner's
///   plane across the edge and follows the straight line over the surface, across further seams, to the
///   texel's distance. Width: width_texels.
/// - Open border (no partner, or the line meets one): only within 2 texels, chart 0, the nearest covered
///   texel's centre, so that bilinear reads at the border find the skin's colour.
///
/// Sources can be read in any order: the bilinear footprint of each (weights above 0) lies on covered texels
/// of one chart. A source too near to a border moves to the nearest such point, usually by less than half a
/// texel.
///
/// Sorted by rows; equal on every run and for any number of threads. Texels without a covered texel near
/// their source are left out. An unwrap that covers the square more than 64 times gets no gutters (with a
/// warning).
std::vector<GutterTexel> build_gutters(const SkinMesh& mesh, int side, int width_texels);

}  // namespace dermis::scene
