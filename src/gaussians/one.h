// SPDX-License-Identifier: MIT
// The cheapest diffusion there is: a single blur.
// Based on: [BL03] Borshukov, Lewis: Realistic human face rendering for The Matrix Reloaded. SIGGRAPH 2003
// sketches
#pragma once

#include "gaussians/sum.h"

namespace dermis::gaussians {

/// One Gaussian that spreads light as far as the sum does: its variance is the mean of r^2 / 2 over the light
/// of all three channels, sum_i w_i v_i averaged over them. Weight 1 in each, so colours no longer bleed.
/// total_reflectance and mean free paths are the sum's; the error is not known.
SumOfGaussians one_gaussian(const SumOfGaussians& sum);

}  // namespace dermis::gaussians
