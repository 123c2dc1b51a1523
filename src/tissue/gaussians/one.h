// SPDX-License-Identifier: MIT
// The cheapest diffusion: a single blur.
// Based on: [BL03] Borshukov, Lewis: Realistic human face rendering for "The Matrix Reloaded".
//           SIGGRAPH 2003 sketches
#pragma once

#include "tissue/gaussians/sum.h"

namespace dermis::gaussians {

/// Returns one Gaussian that spreads light as far as the sum does. Its variance is the mean of r^2 / 2 over
/// the light of all three channels, that is sum_i w_i v_i averaged over them. All weights are 1, so colours
/// no longer bleed. Keeps total_reflectance and mean free paths of the sum; the error is unknown.
ScatterProfile one_gaussian(const ScatterProfile& sum);

}  // namespace dermis::gaussians
