// SPDX-License-Identifier: MIT
// Light must flow across the seams of the unwrap: the empty texels around each chart become a copy of the
// skin that continues there.
#pragma once

#include <cstdint>
#include <vector>

#include "scene/unwrap.h"

namespace dermis::scene {

/// One texel outside the charts, and where on the map the skin that would lie there really is.
struct GutterTexel {
  std::uint16_t x = 0, y = 0;  ///< texel
  /// which chart's surroundings it serves (SkinMesh::triangle_chart); 0 = fill colour only, alpha stays 0
  std::uint16_t chart = 0;
  float source_x = 0, source_y = 0;  ///< texels, centres at .5: read bilinearly here
};

/// The gutters of a map of `side` x `side` texels (1 .. 16384), up to `width_texels` (>= 1) wide.
///
/// Listed are all texels whose centre no triangle covers (the rule of rasterisers, coverage.h), or lies
/// within 1/256 texel of a chart's border, where devices may differ: write gutters after rasterising. Each
/// belongs to the nearest border edge of a chart, Euclidean in texels; at equal distance to the edge it lies
/// more squarely before; then the first.
/// - Border with a partner (the neighbour at the same place lies elsewhere on the map): the owner's plane is
/// unfolded across the edge, then the
///   line goes on straight over the surface, across further seams, to the point at the texel's distance.
///   Width: width_texels.
/// - Open border (no partner, or the line runs into one): only within 2 texels, chart 0, the nearest covered
/// texel's centre, so that
///   bilinear reads at the rim find the skin's colour.
/// Every source is safe to read in any order: its bilinear footprint (weights above 0) touches only covered
/// texels of the chart it lies in. Sources too near to a border move to the nearest such point, usually less
/// than half a texel.
///
/// Sorted by rows; the same on every run and for every number of threads. Texels without any covered texel
/// near their source are left out. An unwrap that covers the square more than 64 times gets no gutters (with
/// a warning).
std::vector<GutterTexel> build_gutters(const SkinMesh& mesh, int side, int width_texels);

}  // namespace dermis::scene
