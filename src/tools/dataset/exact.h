// SPDX-License-Identifier: MIT
// Logarithm, exponential and normal quantile of sums, products and square roots alone, which every machine
// rounds alike: parameters are equal to the bit wherever they are drawn. This room is compiled without fused
// operations.
#pragma once

namespace dermis::dataset {

/// Natural logarithm of x > 0, within 1e-15 of its size or of 1e-15.
double exact_log(double x);
/// e^x for -700 to 700, within 1e-14 of its size.
double exact_exp(double x);
/// The number below which a share p of a normal distribution of mean 0 and deviation 1 lies, 0 < p < 1;
/// relative error 1.2e-9, by P. J. Acklam's rational approximation.
double normal_quantile(double p);

}  // namespace dermis::dataset
