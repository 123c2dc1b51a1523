// SPDX-License-Identifier: MIT
#include "passes/kernels.h"

#include <gtest/gtest.h>

#include <cmath>

namespace dermis::passes {
namespace {

double sum(const HalfKernel& k) {
  double s = k[0];
  for (std::size_t i = 1; i < k.size(); ++i) s += 2 * k[i];
  return s;
}

TEST(Kernels, WeightsSumToOneAndVarianceIsExact) {
  for (double sigma = 0; sigma <= kernel_max_sigma; sigma += 0.05) {
    EXPECT_NEAR(sum(discrete_gaussian(sigma)), 1, 1e-12);
    EXPECT_NEAR(variance(discrete_gaussian(sigma)), sigma * sigma, 1e-6);
    EXPECT_NEAR(sum(texel_averaged_gaussian(sigma)), 1, 1e-12);
  }
}

// The mean over the first dark texel of an edge's Phi: sigma (phi(0) - phi(1/sigma)) - Phi(-1/sigma) ... as
// an integral.
TEST(Kernels, AveragedKernelMatchesAnEdgeOnTexelBorders) {
  for (const double sigma : {0.1, 0.32, 0.88, 1.7}) {
    const HalfKernel k = texel_averaged_gaussian(sigma);
    double leak = 0;
    for (std::size_t i = 1; i < k.size(); ++i) leak += k[i];
    double wanted = 0;
    constexpr int n = 20000;
    for (int i = 0; i < n; ++i) wanted += 0.5 * std::erfc((i + 0.5) / n / sigma / std::sqrt(2.0)) / n;
    EXPECT_NEAR(leak, wanted, 2e-4) << sigma;
  }
}

TEST(Kernels, TableRowsAreWhatTheShaderReads) {
  const std::vector<float> table = kernel_table();
  ASSERT_EQ(table.size(), 2u * kernel_rows * (kernel_radius + 2));
  const std::size_t row = 64, floats = kernel_radius + 2;  // sigma 1
  const HalfKernel k = discrete_gaussian(1);
  for (std::size_t i = 0; i <= kernel_radius; ++i) EXPECT_NEAR(table[row * floats + i], k[i], 1e-6);
  EXPECT_NEAR(table[row * floats + kernel_radius + 1], 1, 1e-5);
}

// The kernel that the shader makes of q.
std::vector<double> of_ratio(double q, int radius) {
  std::vector<double> k(static_cast<std::size_t>(radius) + 1);
  double total = 0;
  for (int i = 0; i <= radius; ++i) {
    k[static_cast<std::size_t>(i)] = i == 0 ? 1 : std::pow(q, i * i);
    total += (i == 0 ? 1 : 2) * k[static_cast<std::size_t>(i)];
  }
  for (double& w : k) w /= total;
  return k;
}

double variance_of(const std::vector<double>& k) {
  double v = 0;
  for (std::size_t i = 1; i < k.size(); ++i) v += 2.0 * static_cast<double>(i * i) * k[i];
  return v;
}

// Kernels of a cascade have the variance of the Gaussian, with few taps and between two entries of the table
// too; narrow ones as far as five taps can.
TEST(Kernels, RatiosKeepTheVariance) {
  const std::vector<float> table = ratio_table();
  ASSERT_EQ(table.size(), 3u * 2u * RATIO_CELLS);
  for (double at = 0.3; at < RATIO_CELLS; at += 0.7) {
    const int cell = static_cast<int>(at);
    const double sigma = RATIO_MAX_SIGMA * at / RATIO_CELLS, f = at - cell;
    const int taps = 1 + cell / RATIO_CELLS_PER_TAP;
    const auto ratio = [&](std::size_t number) {
      const std::size_t i = 2 * (number * RATIO_CELLS + static_cast<std::size_t>(cell));
      return table[i] + f * (table[i + 1] - table[i]);
    };
    const double averaged = texel_averaged_variance(sigma);
    EXPECT_NEAR(variance_of(of_ratio(ratio(0), taps)), sigma * sigma, 2e-4) << sigma;
    EXPECT_NEAR(variance_of(of_ratio(ratio(1), taps)), averaged, 2e-4) << sigma;
    if (sigma > 1.3) continue;
    EXPECT_NEAR(variance_of(of_ratio(ratio(2), NARROW_RADIUS)), averaged, 2e-4) << sigma;
  }
}

// Taps that fall off as q^(k^2) are those of the Gaussian itself, where it is not cut.
TEST(Kernels, RatiosMakeGaussians) {
  for (const double sigma : {0.6, 1.0, 1.5, 2.0}) {
    const int taps = static_cast<int>(std::ceil(8.0 / 3 * sigma));
    const std::vector<double> k = of_ratio(ratio_of_variance(sigma * sigma, taps), taps);
    const HalfKernel whole = discrete_gaussian(sigma);
    for (std::size_t i = 0; i < whole.size(); ++i)
      EXPECT_NEAR(i < k.size() ? k[i] : 0, whole[i], 0.006) << sigma << ", tap " << i;
  }
}

}  // namespace
}  // namespace dermis::passes
