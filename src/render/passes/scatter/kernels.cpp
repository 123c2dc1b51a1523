// SPDX-License-Identifier: MIT
#include "render/passes/scatter/kernels.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace dermis::passes {

static_assert(KERNEL_FLOATS > KERNEL_RADIUS && KERNEL_FLOATS % 4 == 0);

namespace {

HalfKernel normalised(HalfKernel k) {
  double sum = k[0];
  for (int i = 1; i <= kernel_radius; ++i) sum += 2 * k[static_cast<std::size_t>(i)];
  for (double& w : k) w /= sum;
  return k;
}

HalfKernel sampled(double s, int radius = kernel_radius) {
  HalfKernel k{};
  for (int i = 0; i <= radius; ++i)
    k[static_cast<std::size_t>(i)] = s > 0 ? std::exp(-0.5 * i * i / (s * s)) : (i == 0 ? 1.0 : 0.0);
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

HalfKernel discrete_gaussian(double sigma, int radius) {
  if (sigma <= 0) return sampled(0);
  // Sampling narrows a narrow Gaussian, truncation a wide one: bisection for the parameter that gives the
  // wanted variance.
  double low = 0, high = 4 * kernel_max_sigma;
  for (int i = 0; i < 80; ++i) {
    const double middle = 0.5 * (low + high);
    (variance(sampled(middle, radius)) < sigma * sigma ? low : high) = middle;
  }
  return sampled(0.5 * (low + high), radius);
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

static void add_row(std::vector<float>& table, const HalfKernel& kernel) {
  for (const double w : kernel) table.push_back(static_cast<float>(w));
  table.resize(table.size() + KERNEL_FLOATS - kernel.size(), 0.0f);
}

std::vector<float> gaussian_table(int radius) {
  std::vector<float> table;
  for (int row = 0; row < kernel_rows; ++row)
    add_row(table, discrete_gaussian(radius / 3.0 * row / (kernel_rows - 1), radius));
  return table;
}

int reach_of(double sigma) {
  return std::clamp(static_cast<int>(std::ceil(kernel_reach * sigma)), 1, kernel_radius);
}

static std::vector<float> make_kernel_table() {
  static_assert(3 * kernel_max_sigma == kernel_radius);
  const auto sigma = [](int row) { return kernel_max_sigma * row / (kernel_rows - 1); };
  std::vector<float> table;
  // Shaders read as many taps as the lower of two rows has.
  for (int row = 0; row < kernel_rows; ++row)
    add_row(table, discrete_gaussian(sigma(row), reach_of(sigma(std::max(row - 1, 0)))));
  for (int row = 0; row < kernel_rows; ++row) add_row(table, texel_averaged_gaussian(sigma(row)));
  return table;
}

const std::vector<float>& kernel_table() {
  static const std::vector<float> table = make_kernel_table();
  return table;
}

}  // namespace dermis::passes
