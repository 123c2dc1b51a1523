// SPDX-License-Identifier: MIT
#include <gtest/gtest.h>

#include <algorithm>
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

// Squares of the pool hold the maps of every head that uses no more than their side. Steps of a cascade halve
// less often, so that a head of nearly T_max needs twice the side of a near head's halved map.
TEST(Halvings, FitTheirCellAtEverySize) {
  for (const std::uint32_t largest : {512u, 1024u, 2048u})
    for (const std::uint32_t most : {largest, largest / 2, largest / 4})
      for (const bool careful : {false, true})
        for (std::uint32_t n = 0; n <= max_halvings; ++n) {
          const std::uint32_t against = careful ? careful_largest_side(largest) : largest;
          const std::uint32_t cell = most_halved_side(most, against, n);
          std::uint32_t widest = 0;
          for (std::uint32_t side = 32; side <= most; side += 32)
            widest = std::max(widest, halved_side(side, against, n));
          SCOPED_TRACE(testing::Message()
                       << most << " of " << largest << ", careful " << careful << ", " << n);
          EXPECT_LE(widest, cell);
          EXPECT_GT(2 * widest, cell) << "room for nothing";
        }
}

}  // namespace
}  // namespace dermis::passes
