// SPDX-License-Identifier: MIT
#include "tissue/optics/directional_albedo.h"

#include <gtest/gtest.h>

namespace dermis::optics {
namespace {

constexpr double f0 = (0.4 / 2.4) * (0.4 / 2.4);

struct Row {
  double m, at_1, at_08, at_06, at_04, at_03, at_02, at_01, at_005;
};

void expect_rows(std::initializer_list<Row> rows, Masking masking, double tolerance) {
  for (const Row& r : rows) {
    const std::pair<double, double> values[] = {{1.0, r.at_1},  {0.8, r.at_08},  {0.6, r.at_06},
                                                {0.4, r.at_04}, {0.3, r.at_03},  {0.2, r.at_02},
                                                {0.1, r.at_01}, {0.05, r.at_005}};
    for (const auto& [cosine, wanted] : values)
      EXPECT_NEAR(directional_albedo(cosine, r.m, masking).rho(f0) / wanted, 1, tolerance)
          << "m " << r.m << ", cos " << cosine;
  }
}

// Fine quadrature over the directions of light, with F0 of ior 1.4, computed independently.
TEST(DirectionalAlbedo, BySmithMatchesFineQuadrature) {
  expect_rows({{0.1, 0.08726, 0.08878, 0.12388, 0.33228, 0.57557, 0.91807, 1.34593, 1.63332},
               {0.2, 0.08727, 0.09087, 0.13306, 0.28924, 0.43499, 0.64223, 0.94169, 1.15177},
               {0.3, 0.08726, 0.09216, 0.12681, 0.23287, 0.33132, 0.47615, 0.69274, 0.83930},
               {0.4, 0.08647, 0.08925, 0.11524, 0.19259, 0.26443, 0.37209, 0.53314, 0.64006},
               {0.5, 0.08251, 0.08407, 0.10510, 0.16463, 0.22006, 0.30354, 0.42800, 0.51007}},
              Masking::smith, 0.02);
}

TEST(DirectionalAlbedo, ByKelemenMatchesFineQuadrature) {
  expect_rows({{0.2, 0.08378, 0.08576, 0.12040, 0.26147, 0.40142, 0.61022, 0.94282, 1.22602},
               {0.3, 0.07942, 0.08156, 0.10999, 0.21062, 0.31270, 0.47670, 0.76240, 1.01344},
               {0.4, 0.07337, 0.07513, 0.09791, 0.17558, 0.25685, 0.39313, 0.64092, 0.86179},
               {0.5, 0.06594, 0.06808, 0.08736, 0.15099, 0.21892, 0.33582, 0.55407, 0.75064}},
              Masking::kelemen_szirmay_kalos, 0.02);
}

// Smith's form is bounded by what masking leaves of the distribution, also towards a light behind the point.
TEST(DirectionalAlbedo, CosineLambdaIsFiniteAtTheHorizon) {
  EXPECT_NEAR(cosine_lambda(0, 0.3), 0.3 / 3.535, 1e-6);
  EXPECT_EQ(cosine_lambda(1, 0.3), 0);
}

// Mean over diffuse light: 2 Int_0^1 rho(mu, m) mu dmu.
DirectionalAlbedo mean_of(double m, Masking masking) {
  DirectionalAlbedo mean{};
  constexpr int n = 400;
  for (int i = 0; i < n; ++i) {
    const double mu = (i + 0.5) / n;
    const DirectionalAlbedo at = directional_albedo(mu, m, masking);
    mean.of_f0 += 2 * mu * at.of_f0 / n;
    mean.rest += 2 * mu * at.rest / n;
  }
  return mean;
}

TEST(DirectionalAlbedo, TableHoldsTheFunction) {
  const std::vector<float>& table = directional_albedo_table();
  ASSERT_EQ(table.size(), static_cast<std::size_t>(directional_albedo_channels) *
                              (directional_albedo_columns + 2) * directional_albedo_rows);
  const double m =
      directional_albedo_min_m + (1 - directional_albedo_min_m) * 10 / (directional_albedo_rows - 1);
  const std::size_t row = 10u * (directional_albedo_columns + 2) * directional_albedo_channels;
  for (const Masking masking : {Masking::smith, Masking::kelemen_szirmay_kalos}) {
    const std::size_t channel = masking == Masking::smith ? 0 : 2;
    const DirectionalAlbedo at = directional_albedo(40.0 / (directional_albedo_columns - 1), m, masking),
                            mean = mean_of(m, masking);
    const float* entry = &table[row + 40 * directional_albedo_channels + channel];
    EXPECT_NEAR(entry[0], at.of_f0, 1e-5);
    EXPECT_NEAR(entry[1], at.rest, 1e-5);
    const float* mean_entry =
        &table[row + directional_albedo_columns * directional_albedo_channels + channel];
    EXPECT_NEAR(mean_entry[0] / mean.of_f0, 1, 2e-3);
    EXPECT_NEAR(mean_entry[1] / mean.rest, 1, 2e-3);
  }
}

}  // namespace
}  // namespace dermis::optics
