// SPDX-License-Identifier: MIT
#include "passes/kernels.h"

#include <cmath>
#include <numbers>

namespace dermis::passes {

static_assert(KERNEL_FLOATS == KERNEL_RADIUS + 2);

namespace {

HalfKernel normalised(HalfKernel k) {
  double sum = k[0];
  for (int i = 1; i <= kernel_radius; ++i) sum += 2 * k[static_cast<std::size_t>(i)];
  for (double& w : k) w /= sum;
  return k;
}

HalfKernel sampled(double s) {
  HalfKernel k{};
  for (int i = 0; i <= kernel_radius; ++i)
    k[static_cast<std::size_t>(i)] = s > 0 ? std::exp(-0.5 * i * i / (s * s)) : (i == 0 ? 1.0 : 0.0);
  return normalised(k);
}

HalfKernel cut(HalfKernel k, int radius) {
  for (int i = radius + 1; i <= kernel_radius; ++i) k[static_cast<std::size_t>(i)] = 0;
  return normalised(k);
}

// Returns the second antiderivative of a normal density of this sigma: int int G.
double second_integral(double x, double sigma) {
  const double z = x / sigma;
  const double density = std::exp(-0.5 * z * z) / std::sqrt(2 * std::numbers::pi);
  const double cumulative = 0.5 * std::erfc(-z / std::numbers::sqrt2);
  return sigma * (z * cumulative + density);
}

}  // namespace

double variance(const HalfKernel& kernel) {
  double v = 0;
  for (int i = 1; i <= kernel_radius; ++i) v += 2.0 * i * i * kernel[static_cast<std::size_t>(i)];
  return v;
}

HalfKernel discrete_gaussian(double sigma) {
  if (sigma <= 0) return sampled(0);
  // Sampling narrows a narrow Gaussian, truncation a wide one: bisection for the parameter that gives the
  // wanted variance.
  double low = 0, high = 4 * kernel_max_sigma;
  for (int i = 0; i < 80; ++i) {
    const double middle = 0.5 * (low + high);
    (variance(sampled(middle)) < sigma * sigma ? low : high) = middle;
  }
  return sampled(0.5 * (low + high));
}

HalfKernel texel_averaged_gaussian(double sigma) {
  if (sigma <= 0) return sampled(0);
  // tri * G at integer offsets is the second difference of the second integral.
  HalfKernel k{};
  for (int i = 0; i <= kernel_radius; ++i)
    k[static_cast<std::size_t>(i)] =
        second_integral(i + 1, sigma) - 2 * second_integral(i, sigma) + second_integral(i - 1, sigma);
  return normalised(k);
}

HalfKernel narrow_gaussian(double sigma) {
  // What the cut takes off the variance, a wider Gaussian gives back.
  const double wanted = variance(texel_averaged_gaussian(sigma));
  double low = 0, high = 4 * kernel_max_sigma;
  for (int i = 0; i < 60; ++i) {
    const double middle = 0.5 * (low + high);
    (variance(cut(texel_averaged_gaussian(middle), NARROW_RADIUS)) < wanted ? low : high) = middle;
  }
  return cut(texel_averaged_gaussian(0.5 * (low + high)), NARROW_RADIUS);
}

std::vector<float> kernel_table() {
  std::vector<float> table;
  for (const auto& gaussian : {discrete_gaussian, texel_averaged_gaussian, narrow_gaussian})
    for (int row = 0; row < kernel_rows; ++row) {
      const HalfKernel kernel = gaussian(kernel_max_sigma * row / (kernel_rows - 1));
      for (const double w : kernel) table.push_back(static_cast<float>(w));
      table.push_back(static_cast<float>(variance(kernel)));
    }
  return table;
}

}  // namespace dermis::passes
