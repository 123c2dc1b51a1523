// SPDX-License-Identifier: MIT
#include <gtest/gtest.h>

#include <cmath>

#include "gaussians/known.h"
#include "passes/downsample/downsample.h"

namespace dermis::passes {
namespace {

TEST(Halvings, LeaveASigmaOfATexel) {
  const gaussians::SumOfGaussians profile = gaussians::skin_six();
  for (const double density : {0.3, 1.0, 4.0, 30.0}) {
    const std::vector<std::uint32_t> halvings = map_halvings(profile, density, 2048);
    ASSERT_EQ(halvings.size(), 6u);
    EXPECT_EQ(halvings[0], 0u);
    for (std::size_t k = 1; k < 6; ++k) {
      const double sigma_texels = std::sqrt(profile.terms[k - 1].variance_mm2) * density;
      EXPECT_GE(halvings[k], halvings[k - 1]);
      EXPECT_LE(halvings[k], max_halvings);
      EXPECT_TRUE(halvings[k] == 0 || sigma_texels >= (1u << halvings[k])) << density;
      EXPECT_TRUE(halvings[k] == max_halvings || sigma_texels < (2u << halvings[k])) << density;
    }
  }
}

TEST(Halvings, DivideTheMap) {
  for (const std::uint32_t size : {1000u, 1001u, 1002u, 1004u})
    for (const std::uint32_t n : map_halvings(gaussians::skin_six(), 100, size))
      EXPECT_EQ(size % (1u << n), 0u) << size;
}

TEST(Halvings, FitTheirPoolAtEverySize) {
  for (std::uint32_t n = 0; n <= max_halvings; ++n)
    for (std::uint32_t side = 32; side <= 2048; side += 32) {
      const std::uint32_t halved = halved_side(side, 2048, n);
      EXPECT_LE(halved, 2048u >> n);
      EXPECT_LE(halved, side);
      EXPECT_GE(halved, std::min(side, (2048u >> n) / 2)) << "less than half the texels of a near head";
      EXPECT_EQ(side % halved, 0u);
    }
}

}  // namespace
}  // namespace dermis::passes
