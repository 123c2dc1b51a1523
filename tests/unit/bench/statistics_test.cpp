// SPDX-License-Identifier: MIT
#include "cli/bench/statistics.h"

#include <gtest/gtest.h>

#include <random>

namespace dermis::cli::bench {
namespace {

TEST(Spread, MedianAndExtremes) {
  EXPECT_EQ(spread_of({7}).median, 7);
  EXPECT_EQ(spread_of({9, 1, 2}).median, 2);
  EXPECT_EQ(spread_of({9, 1, 2, 4}).median, 3);
  const Spread s = spread_of({5, 3, 8, 100});
  EXPECT_EQ(s.min, 3);
  EXPECT_EQ(s.max, 100);
}

TEST(Times, ThatOverlapHaveNotChanged) {
  for (const std::vector<double>& after :
       {std::vector<double>{10, 11, 12}, {11.9, 13, 14}, {12, 12, 12}, {8, 9, 10}, {1, 100, 200}}) {
    const Comparison c = compare_times({10, 11, 12}, after);
    EXPECT_EQ(c.change, Change::none) << after.front();
    EXPECT_EQ(c.beyond, 0);
  }
  EXPECT_NEAR(compare_times({10, 11, 12}, {11, 12.1, 13}).ratio, 1.1, 1e-12)
      << "the ratio is there all the same";
}

TEST(Times, BeyondTheSpread) {
  const Comparison slower = compare_times({10, 12, 11}, {15, 14, 13.1});
  EXPECT_EQ(slower.change, Change::slower);
  EXPECT_NEAR(slower.ratio, 14.0 / 11, 1e-12);
  EXPECT_NEAR(slower.beyond, 1.1 / 11, 1e-12);
  const Comparison faster = compare_times({10, 12, 11}, {9, 8, 7});
  EXPECT_EQ(faster.change, Change::faster);
  EXPECT_NEAR(faster.beyond, 1.0 / 11, 1e-12);
}

TEST(Times, OneStrayRoundMakesNoChange) {
  EXPECT_EQ(compare_times({10, 11, 12}, {10, 11, 500}).change, Change::none);
  EXPECT_EQ(compare_times({10, 11, 500}, {13, 14, 15}).change, Change::none) << "it may hide one";
}

// Equal sources are told apart as rarely as chance() says: 1 in 20 for three rounds each.
TEST(Times, ChanceIsWhatHappens) {
  EXPECT_NEAR(chance(3, 3), 1.0 / 20, 1e-12);
  EXPECT_NEAR(chance(5, 5), 1.0 / 252, 1e-12);
  EXPECT_NEAR(chance(1, 1), 0.5, 1e-12);
  EXPECT_NEAR(chance(1, 4), 1.0 / 5, 1e-12);
  std::mt19937 random(7);
  std::lognormal_distribution<double> time(1, 0.3);
  constexpr int trials = 40000;
  int slower = 0, faster = 0;
  for (int i = 0; i < trials; ++i) {
    std::vector<double> before(3), after(3);
    for (double& t : before) t = time(random);
    for (double& t : after) t = time(random);
    const Change change = compare_times(before, after).change;
    slower += change == Change::slower, faster += change == Change::faster;
  }
  EXPECT_NEAR(slower, trials / 20.0, 5 * std::sqrt(trials / 20.0));
  EXPECT_NEAR(faster, trials / 20.0, 5 * std::sqrt(trials / 20.0));
}

}  // namespace
}  // namespace dermis::cli::bench
