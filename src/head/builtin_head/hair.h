// SPDX-License-Identifier: MIT
// Hairs of the brows: strokes seen from the front, looked up by position.
#pragma once

#include <vector>

#include "head/builtin_head/clay.h"

namespace dermis::builtin_head {

/// Tapered strokes in the x, y plane of the face (mm, both halves), in buckets.
class Hairs {
 public:
  Hairs();
  /// Returns how much of the skin at (x, y) is covered, 0..1; `softness_mm` is the width of an edge.
  float coverage(const vec2& at_mm, float softness_mm) const;

 private:
  struct Piece {
    vec2 from{0}, to{0};
    float width_from_mm = 0, width_to_mm = 0;
  };
  void add(const vec2& root, float angle, float turn, float length_mm, float width_mm);
  void add_brow(float side);
  void sort_into_buckets();
  static constexpr float bucket_mm = 1.5f;
  static constexpr int buckets_x = 88, buckets_y = 40;
  static constexpr float left_mm = -66.0f, bottom_mm = -24.0f;
  std::vector<Piece> pieces_;
  std::vector<std::uint32_t> start_, order_;
};

}  // namespace dermis::builtin_head
