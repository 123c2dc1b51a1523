// SPDX-License-Identifier: MIT
#include "render/techniques/published/kernels.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

#include "render/techniques/published/blur_io.h"

namespace dermis::techniques::papers {
namespace {

constexpr int taps = PAPER_TAPS;
constexpr double max_sigma = PAPER_MAX_SIGMA;
using Kernel = std::array<double, PAPER_TAPS + 1>;  // weights of taps 0, +-1, ..; w0 + 2 sum = 1

Kernel normalised(Kernel kernel) {
  double sum = kernel[0];
  for (std::size_t i = 1; i < kernel.size(); ++i) sum += 2 * kernel[i];
  for (double& weight : kernel) weight /= sum;
  return kernel;
}

Kernel sampled(double sigma) {
  Kernel kernel{};
  for (int i = 0; i <= taps; ++i)
    kernel[static_cast<std::size_t>(i)] =
        sigma > 0 ? std::exp(-0.5 * i * i / (sigma * sigma)) : (i == 0 ? 1.0 : 0.0);
  return normalised(kernel);
}

double variance(const Kernel& kernel) {
  double sum = 0;
  for (int i = 1; i <= taps; ++i) sum += 2.0 * i * i * kernel[static_cast<std::size_t>(i)];
  return sum;
}

// Sampling narrows a narrow Gaussian, truncation a wide one: bisection for the parameter that gives the
// wanted variance.
Kernel of_exact_variance(double sigma) {
  if (sigma <= 0) return sampled(0);
  double low = 0, high = 4 * max_sigma;
  for (int i = 0; i < 80; ++i) {
    const double middle = 0.5 * (low + high);
    (variance(sampled(middle)) < sigma * sigma ? low : high) = middle;
  }
  return sampled(0.5 * (low + high));
}

// Returns the second antiderivative of a normal density of this sigma: int int G.
double second_integral(double x, double sigma) {
  const double z = x / sigma;
  const double density = std::exp(-0.5 * z * z) / std::sqrt(2 * std::numbers::pi);
  const double cumulative = 0.5 * std::erfc(-z / std::numbers::sqrt2);
  return sigma * (z * cumulative + density);
}

// A box of a texel, convolved with the Gaussian, averaged over a texel: the second difference of int int G.
Kernel averaged_over_texels(double sigma) {
  if (sigma <= 0) return sampled(0);
  Kernel kernel{};
  for (int i = 0; i <= taps; ++i)
    kernel[static_cast<std::size_t>(i)] =
        second_integral(i + 1, sigma) - 2 * second_integral(i, sigma) + second_integral(i - 1, sigma);
  return normalised(kernel);
}

std::vector<float> make_kernel_table() {
  std::vector<float> table;
  for (const auto kernel_of : {of_exact_variance, averaged_over_texels})
    for (int row = 0; row < PAPER_ROWS; ++row) {
      for (const double weight : kernel_of(max_sigma * row / (PAPER_ROWS - 1)))
        table.push_back(static_cast<float>(weight));
      table.push_back(0);  // to whole texels
    }
  return table;
}

}  // namespace

const std::vector<float>& kernel_table() {
  static const std::vector<float> table = make_kernel_table();
  return table;
}

std::vector<Step> steps_of(const ScatterProfile& profile, double max_texels_per_mm) {
  std::vector<Step> steps;
  const double first_sigma = max_sigma / max_texels_per_mm;
  double done_mm2 = 0;
  const auto add = [&](double to_mm2, bool ends_term) {
    steps.push_back({.variance_mm2 = to_mm2 - done_mm2, .ends_term = ends_term});
    done_mm2 = to_mm2;
  };

  for (const Gaussian& term : profile.terms) {
    while (true) {
      // Sigma doubles at most; but below the size of a texel one step suffices, for with a tap spacing of one
      // texel no light can be skipped.
      const double reach_mm2 = done_mm2 == 0 ? first_sigma * first_sigma : 4 * done_mm2;
      const double limit_mm2 = std::max(reach_mm2, done_mm2 + first_sigma * first_sigma);
      if (term.variance_mm2 <= limit_mm2 * (1 + 1e-9)) break;
      add(limit_mm2, false);
    }
    add(term.variance_mm2, true);
  }
  return steps;
}

int seam_width(const ScatterProfile& profile, double max_texels_per_mm) {
  double widest_mm2 = 0;
  for (const Step& step : steps_of(profile, max_texels_per_mm))
    widest_mm2 = std::max(widest_mm2, step.variance_mm2);
  const double reach = std::ceil(taps / max_sigma * std::sqrt(widest_mm2) * max_texels_per_mm) + 2;
  return static_cast<int>(std::clamp(reach, 3.0, 96.0));
}

}  // namespace dermis::techniques::papers
