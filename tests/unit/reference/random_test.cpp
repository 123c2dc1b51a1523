// SPDX-License-Identifier: MIT
// Numbers of a block are one in each eighth, uniform, and independent from one draw to the next.
#include "truth/reference/random.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

namespace dermis::reference {
namespace {

TEST(RandomNumbers, ABlockHasOneInEachStratum) {
  for (std::uint32_t block = 0; block < 200; ++block) {
    std::vector<Random> samples;
    for (std::uint32_t k = 0; k < samples_a_block; ++k)
      samples.push_back(random_of(5, 17, block * samples_a_block + k));
    for (int draw = 0; draw < 20; ++draw) {
      std::array<double, samples_a_block> u{};
      for (std::size_t k = 0; k < u.size(); ++k) u[k] = samples[k].next();
      std::sort(u.begin(), u.end());
      for (std::size_t k = 0; k < u.size(); ++k) {
        EXPECT_GT(u[k], 0);
        EXPECT_LT(u[k], 1);
        EXPECT_NEAR(u[k] - u[0], static_cast<double>(k) / samples_a_block, 1e-9)
            << "shifted as a whole, in an order of its own";
      }
    }
  }
}

// Of any two numbers of one sample, all pairs of eighths come equally often; 4 standard errors of the counts.
TEST(RandomNumbers, DrawsAreUniformAndIndependent) {
  constexpr int n = 80'000, cells = 8;
  for (const auto& [first, second] : std::array<std::array<int, 2>, 4>{{{0, 1}, {0, 7}, {3, 4}, {2, 11}}}) {
    std::array<std::array<int, cells>, cells> count{};
    double product = 0;
    for (std::uint32_t k = 0; k < n; ++k) {
      Random random = random_of(9, k / 400, k % 400);
      std::array<double, 12> u{};
      for (double& value : u) value = random.next();
      const double a = u[static_cast<std::size_t>(first)], b = u[static_cast<std::size_t>(second)];
      ++count[static_cast<std::size_t>(a * cells)][static_cast<std::size_t>(b * cells)];
      product += (a - 0.5) * (b - 0.5);
    }
    const double expected = double{n} / (cells * cells);
    for (const auto& row : count)
      for (const int c : row) EXPECT_NEAR(c, expected, 4.5 * std::sqrt(expected)) << first << ", " << second;
    EXPECT_NEAR(product / n, 0, 4 / 12.0 / std::sqrt(n));
  }
}

}  // namespace
}  // namespace dermis::reference
