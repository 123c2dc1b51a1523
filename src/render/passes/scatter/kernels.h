// SPDX-License-Identifier: MIT
/// Discrete Gaussians with exact variance, tabulated for the convolution. Seven taps one sigma apart, as
/// printed in [DLE07], have variance 1.079 sigma^2. They miss a lit edge by up to 18 % at a width of one
/// texel or less. Here taps lie on whole texels.
#pragma once

#include <array>
#include <vector>

#include "render/passes/scatter/kernels_io.h"

namespace dermis::passes {

inline constexpr int kernel_radius = KERNEL_RADIUS;
inline constexpr double kernel_max_sigma = KERNEL_MAX_SIGMA;
inline constexpr double spaced_max_sigma = SPACED_MAX_SIGMA;
inline constexpr int kernel_rows = KERNEL_ROWS;
/// Taps per side that a blur reads, per tap spacing of its sigma.
inline constexpr double kernel_reach = kernel_radius / kernel_max_sigma;

using HalfKernel =
    std::array<double, kernel_radius + 1>;  ///< weights of taps 0, +-1, .. +-12; w0 + 2 sum = 1

/// Returns a sampled Gaussian of taps 0, +-1, .. +-radius whose weights sum to 1 and whose variance is
/// sigma^2 exactly (sigma 0..radius / 3).
HalfKernel discrete_gaussian(double sigma, int radius = kernel_radius);

/// Returns a Gaussian between texels as squares: the mean over a texel of the light from a neighbouring texel
/// of unit light. For light that no blur has spread, which is constant over each texel: exact for edges on
/// texel borders, however narrow the Gaussian. Blurs read reach_of() taps: the variance is 1 to 2 % less
/// then.
HalfKernel texel_averaged_gaussian(double sigma);

double variance(const HalfKernel& kernel);

/// Returns the taps on either side that hold a Gaussian: kernel_reach of them, at least one.
int reach_of(double sigma);

/// Returns two tables of kernel_rows rows of KERNEL_FLOATS floats: discrete_gaussian,
/// texel_averaged_gaussian. Made once.
const std::vector<float>& kernel_table();

/// Returns kernel_rows rows of KERNEL_FLOATS floats: discrete_gaussian() of this radius, sigma 0..radius / 3.
std::vector<float> gaussian_table(int radius);

}  // namespace dermis::passes
