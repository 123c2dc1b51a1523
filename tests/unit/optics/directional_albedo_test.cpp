// SPDX-License-Identifier: MIT
#include "optics/directional_albedo.h"

#include <gtest/gtest.h>

namespace dermis::optics {
namespace {

constexpr double f0 = (0.4 / 2.4) * (0.4 / 2.4);

// Fine quadrature of the Kelemen lobe with F0 of ior 1.4, computed independently.
TEST(DirectionalAlbedo, MatchesFineQuadrature) {
  struct Row {
    double m, at_1, at_08, at_06, at_04, at_03, at_02;
  };
  for (const Row& r : {Row{0.2, 0.08378, 0.08576, 0.12040, 0.26147, 0.40142, 0.61022},
                       Row{0.3, 0.07942, 0.08156, 0.10999, 0.21062, 0.31270, 0.47670},
                       Row{0.4, 0.07337, 0.07513, 0.09791, 0.17558, 0.25685, 0.39313},
                       Row{0.5, 0.06594, 0.06808, 0.08736, 0.15099, 0.21892, 0.33582}}) {
    const std::pair<double, double> values[] = {{1.0, r.at_1},  {0.8, r.at_08}, {0.6, r.at_06},
                                                {0.4, r.at_04}, {0.3, r.at_03}, {0.2, r.at_02}};
    for (const auto& [cosine, wanted] : values)
      EXPECT_NEAR(directional_albedo(cosine, r.m).rho(f0) / wanted, 1, 0.02)
          << "m " << r.m << ", cos " << cosine;
  }
}

TEST(DirectionalAlbedo, MeanIsTheCosineWeightedMean) {
  double mean = 0;
  constexpr int n = 400;
  for (int i = 0; i < n; ++i) {
    const double mu = (i + 0.5) / n;
    mean += 2 * mu * directional_albedo(mu, 0.3).rho(f0) / n;
  }
  EXPECT_NEAR(mean_directional_albedo(0.3).rho(f0) / mean, 1, 2e-3);
}

TEST(DirectionalAlbedo, TableHoldsTheFunction) {
  const std::vector<float> table = directional_albedo_table();
  ASSERT_EQ(table.size(), 2u * (directional_albedo_columns + 2) * directional_albedo_rows);
  const double m =
      directional_albedo_min_m + (1 - directional_albedo_min_m) * 10 / (directional_albedo_rows - 1);
  const std::size_t at = (10u * (directional_albedo_columns + 2) + 40) * 2;
  EXPECT_NEAR(table[at], directional_albedo(40.0 / (directional_albedo_columns - 1), m).of_f0, 1e-5);
}

}  // namespace
}  // namespace dermis::optics
