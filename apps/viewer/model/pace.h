// SPDX-License-Identifier: MIT
/// Size of a picture while something changes, so that it follows the hand on a slow device too.
#pragma once

#include <array>
#include <cstddef>

#include "dermis/settings.h"

namespace dermis::viewer {

/// Chooses by what earlier pictures took. Only what is on the screen depends on it: never a file.
class Pace {
 public:
  /// By how much each level divides the sides of the picture.
  static constexpr std::array<int, 6> divisors{1, 2, 3, 4, 6, 8};

  /// Takes what a picture took at the level that settings() had.
  void drew(double ms);

  int divisor() const { return divisors[level_]; }

  /// Returns the settings for a picture while something changes: smaller, and with maps to match.
  RenderSettings settings(const RenderSettings& full) const;

 private:
  std::size_t level_ = 3;
  int quick_ = 0;  ///< pictures in a row that left much time over
};

/// A picture while something changes should take no longer.
inline constexpr double pace_ms = 60;
/// Side of the maps of such pictures, texels, at most.
inline constexpr int moving_map_size = 128;

}  // namespace dermis::viewer
