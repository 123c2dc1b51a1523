// SPDX-License-Identifier: MIT
// Maps texture coordinates to pixels.
#pragma once

#include <algorithm>
#include <cmath>

#include "head/scene/asset_data.h"

namespace dermis::scene {

/// Returns the pixel 0 .. size - 1 that stands for pixel `i`.
inline int wrapped(int i, int size, AssetWrap wrap) {
  if (wrap == AssetWrap::clamp) return std::clamp(i, 0, size - 1);
  const int period = wrap == AssetWrap::mirror ? 2 * size : size;
  i %= period;
  if (i < 0) i += period;
  return i < size ? i : period - 1 - i;
}

/// Returns the whole part, and writes the rest, 0..1. Coordinates beyond the range of int (hostile files)
/// become 0.
inline int split(double x, double& rest) {
  const double whole = std::floor(x);
  rest = x - whole;
  return std::abs(whole) < 1e9 ? static_cast<int>(whole) : 0;
}

}  // namespace dermis::scene
