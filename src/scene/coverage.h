// SPDX-License-Identifier: MIT
// Which texels a triangle of the unwrap covers, by the rule that rasterisers follow.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <glm/glm.hpp>

#include "scene/unwrap.h"

namespace dermis::scene {

/// Columns [begin, end) of one row.
struct TexelSpan {
  int y, begin, end;
};

/// A triangle in 1/256 texels, the precision to which Vulkan devices snap vertices (subPixelPrecisionBits 8),
/// counter to the sign of its area if need be: exact edge functions, so triangles that share an edge never
/// cover a texel twice and never leave one out.
class TexelTriangle {
 public:
  /// Coordinates 0..1 times `side` texels (1 .. 16384).
  TexelTriangle(const std::array<glm::vec2, 3>& uv, int side);

  int first_row() const { return first_row_; }
  int end_row() const { return end_row_; }
  /// Texels of the row whose centre lies inside, or on a top or left edge.
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

/// Unwrap coordinates of triangle t.
std::array<glm::vec2, 3> triangle_uv(const SkinMesh& mesh, std::size_t t);

/// How often the unwrap covers the unit square in all: the sum of its triangles' areas. Over 1 it must
/// overlap.
double uv_area_sum(const SkinMesh& mesh);

/// Of the texels (centres, resolution x resolution) that any triangle covers, the share that more than one
/// covers. 0 if none is covered. An unwrap that covers the square more than 64 times is not rasterised to the
/// end: 1.
double uv_overlap_fraction(const SkinMesh& mesh, int resolution = 1024);

/// Warns if more than 0.5 % overlap: how much, what will look wrong, what to do. Returns the fraction.
double warn_overlap(const SkinMesh& mesh);

}  // namespace dermis::scene
