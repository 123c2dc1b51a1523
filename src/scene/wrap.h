// SPDX-License-Identifier: MIT
// Where a texture coordinate falls in a picture.
#pragma once

#include <algorithm>
#include <cmath>

#include "scene/scene.h"

namespace dermis::scene {

/// The pixel that stands for pixel `i` of a side of `size` pixels, 0 .. size - 1.
inline int wrapped(int i, int size, Wrap wrap) {
  if (wrap == Wrap::clamp) return std::clamp(i, 0, size - 1);
  const int period = wrap == Wrap::mirror ? 2 * size : size;
  i %= period;
  if (i < 0) i += period;
  return i < size ? i : period - 1 - i;
}

/// The whole part, and into `rest` what is left, 0..1; coordinates beyond what an int holds (hostile files)
/// are brought back first, which a repeat cannot notice.
inline int split(double x, double& rest) {
  const double whole = std::floor(x);
  rest = x - whole;
  return std::abs(whole) < 1e9 ? static_cast<int>(whole) : 0;
}

}  // namespace dermis::scene
