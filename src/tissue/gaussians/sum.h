// SPDX-License-Identifier: MIT
// A diffusion profile as a sum of Gaussians, the form that the GPU can blur.
//   R(r) = sum_i w_i G(v_i, r),  G(v, r) = exp(-r^2 / (2 v)) / (2 pi v)   [1/mm^2]
// Based on:
// [DLE07] d'Eon, Luebke, Enderton: Efficient Rendering of Human Skin. EGSR 2007, sec. 4
// [JG08]  Jimenez, Gutierrez: Faster Rendering of Human Skin. CEIG 2008, eq. 2
#pragma once

#include <array>

#include "dermis/profile.h"

namespace dermis::gaussians {

using Rgb = std::array<double, 3>;

inline constexpr int max_terms = 8;
inline constexpr double weight_tolerance = 1e-3;  ///< of the sum of a channel's weights, which is 1

}  // namespace dermis::gaussians
