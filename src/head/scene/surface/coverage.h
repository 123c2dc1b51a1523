// SPDX-License-Identifier: MIT
// Finds the texels that a triangle of the unwrap covers, by the rule of rasterisers.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <glm/glm.hpp>

#include "head/scene/surface/unwrap.h"

namespace dermis::scene {

/// Columns [begin, end) of one row.
struct TexelSpan {
  int y, begin, end;
};

/// A triangle in 1/256 texels, the precision to which Vulkan devices snap vertices (subPixelPrecisionBits 8),
/// reversed if its area is negative. Edge functions are exact, so triangles that share an edge cover each
/// texel exactly once.
class TexelTriangle {
 public:
  /// Takes coordinates 0..1 on a map of `side` texels (1 .. 16384).
  TexelTriangle(const std::array<glm::vec2, 3>& uv, int side);

  int first_row() const { return first_row_; }
  int end_row() const { return end_row_; }
  /// Returns the texels of a row whose centre lies inside, or on a top or left edge.
  TexelSpan row(int y) const;

 private:
  std::array<std::int64_t, 3> x_{}, y_{};
  int side_, first_row_ = 0, end_row_ = 0;
};

/// Calls visit(x, y) for each covered texel, rows from top to bottom. Cost: rows + texels.
template <class Visit>
void for_each_texel(const std::array<glm::vec2, 3>& uv, int side, const Visit& visit) {
  const TexelTriangle triangle(uv, side);
  for (int y = triangle.first_row(); y < triangle.end_row(); ++y) {
    const TexelSpan span = triangle.row(y);
    for (int x = span.begin; x < span.end; ++x) visit(x, y);
  }
}

/// Returns the unwrap coordinates of triangle t.
std::array<glm::vec2, 3> triangle_uv(const SkinMesh& mesh, std::size_t t);

/// Returns the sum of the areas of all triangles on the unit square. Over 1, the unwrap must overlap.
double uv_area_sum(const SkinMesh& mesh);

/// Returns the share of covered texels (centres, resolution x resolution) that more than one triangle covers;
/// 0 if none is covered. Returns 1, without rasterising to the end, if the unwrap covers the square more than
/// 64 times.
double uv_overlap_fraction(const SkinMesh& mesh, int resolution = 1024);

/// Warns if more than 0.5 % of a measured mesh overlap: how much, what will look wrong, how to correct it.
void warn_overlap(const SkinMesh& mesh);

}  // namespace dermis::scene
