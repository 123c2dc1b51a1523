// SPDX-License-Identifier: MIT
// The one-dimensional filters of FLIP. Every two-dimensional filter of the paper
// is a product of two of these (or a sum of two products). So filtering along rows and then along columns
// gives the same sums.
#pragma once

#include <array>
#include <vector>

namespace dermis::image::flip {

/// Taps -radius to radius; all seven have the same radius, shorter ones are padded with zeros.
using Taps = std::vector<float>;

/// [ANAMOF20] sec. 4.1.1: what the eye cannot resolve, per opponent channel. The blue-yellow filter is a sum
/// of two Gaussians: cz_wide x cz_wide + cz_narrow x cz_narrow. [ANAMOF20] sec. 4.2: a Gaussian and its first
/// two derivatives find edges and points.
struct Filters {
  int radius = 0;
  Taps y, cx, cz_wide, cz_narrow;  ///< y, cx sum to 1; the squares of the sums of the two cz add up to 1
  /// smooth sums to 1; the positive and the negative taps of edge and of point to 1 and -1
  Taps smooth, edge, point;
};

Filters make_filters(double pixels_per_degree);

}  // namespace dermis::image::flip
