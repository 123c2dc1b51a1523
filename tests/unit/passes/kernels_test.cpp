// SPDX-License-Identifier: MIT
#include "render/passes/scatter/kernels.h"

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
  ASSERT_EQ(table.size(), 2u * kernel_rows * KERNEL_FLOATS);
  const std::size_t row = 64;  // sigma 1
  ASSERT_EQ(reach_of(1), 3);
  const HalfKernel k = discrete_gaussian(1, 3);
  for (std::size_t i = 0; i < k.size(); ++i) EXPECT_NEAR(table[row * KERNEL_FLOATS + i], k[i], 1e-6);
  EXPECT_NEAR(variance(k), 1, 1e-5);
}

// A blur reads no more taps than this, and the variance is exact with them.
TEST(Kernels, TapsHoldTheVariance) {
  for (double sigma = 0.05; sigma <= kernel_max_sigma; sigma += 0.05) {
    const HalfKernel k = discrete_gaussian(sigma, reach_of(sigma));
    EXPECT_NEAR(variance(k), sigma * sigma, 1e-6) << sigma;
    for (std::size_t i = static_cast<std::size_t>(reach_of(sigma)) + 1; i < k.size(); ++i) EXPECT_EQ(k[i], 0);
  }
}

// Shaders mix two rows and read as many taps as their sigma has.
TEST(Kernels, MixesOfRowsHoldTheVariance) {
  const std::vector<float>& table = kernel_table();
  for (double sigma = 0.3; sigma < kernel_max_sigma; sigma += 0.0007) {
    const double row = sigma / kernel_max_sigma * (kernel_rows - 1);
    const auto low = static_cast<std::size_t>(row);
    const auto weight = [&](std::size_t k) {
      return std::lerp(double{table[low * KERNEL_FLOATS + k]}, double{table[(low + 1) * KERNEL_FLOATS + k]},
                       row - static_cast<double>(low));
    };
    double total = weight(0), squares = 0;
    for (std::size_t k = 1; k <= static_cast<std::size_t>(reach_of(sigma)); ++k) {
      total += 2 * weight(k);
      squares += 2 * static_cast<double>(k * k) * weight(k);
    }
    ASSERT_NEAR(squares / total / (sigma * sigma), 1, 1e-3) << sigma;
  }
}

}  // namespace
}  // namespace dermis::passes
