// SPDX-License-Identifier: MIT
// The position of a point on the face: which part of it this is.
#pragma once

#include <array>
#include <bit>

#include "head/builtin_head/clay.h"

namespace dermis::builtin_head {

/// All 0..1 unless said otherwise. Varies over millimetres, so it is computed on a net and interpolated.
struct Region {
  vec3 symmetric{0};  ///< mm; x keeps its sign (left is positive), the painter takes |x|
  vec3 line{0};       ///< relaxed skin tension line, up to 1 long
  float lips = 0, cheek = 0, nose_tip = 0, nose = 0, ear = 0, forehead = 0, t_zone = 0;
  float under_eye = 0, upper_lid = 0, beard = 0, scalp = 0, neck = 0, crow = 0, chin = 0;
  // Unevenness, about -1..1: of all pigments, of their blotches, of the blood, of the film of oil.
  float complexion = 0, mottle = 0, blood = 0, oil = 0;
};
/// Returns a + t (b - a) for every member: all are numbers, one after the other.
inline Region blend(const Region& a, const Region& b, float t) {
  using Numbers = std::array<float, sizeof(Region) / sizeof(float)>;
  const auto from = std::bit_cast<Numbers>(a), to = std::bit_cast<Numbers>(b);
  Numbers between;
  for (std::size_t k = 0; k < between.size(); ++k) between[k] = from[k] + t * (to[k] - from[k]);
  return std::bit_cast<Region>(between);
}

}  // namespace dermis::builtin_head
