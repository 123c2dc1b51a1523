// SPDX-License-Identifier: MIT
#include "truth/reference/specular.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

namespace dermis::reference {
namespace {

constexpr double f0 = 0.028;
const glm::dvec3 n(0, 0, 1);

glm::dvec3 direction(double cosine, double phi) {
  const double sine = std::sqrt(1 - cosine * cosine);
  return {sine * std::cos(phi), sine * std::sin(phi), cosine};
}

/// The same lobe twice, so that weights count.
SkinSpecular lobes_of(double m) { return {.rho_s = 0.18, .f0 = f0, .m = {m, m}, .weight = {0.6, 0.4}}; }

// What the lobes reflect over all directions is what the table says, up to the horizon.
TEST(SkinSpecular, SumsToItsDirectionalAlbedo) {
  const ReflectanceTable table;
  for (const double m : {0.15, 0.3, 0.5})
    for (const double cosine : {1.0, 0.5, 0.2, 0.05}) {
      constexpr int rows = 600, columns = 600;
      double sum = 0;
      for (int i = 0; i < rows; ++i)
        for (int j = 0; j < columns; ++j) {
          const double cosine_l = (i + 0.5) / rows;
          const glm::dvec3 l = direction(cosine_l, std::numbers::pi * (j + 0.5) / columns);
          sum += specular_brdf(lobes_of(m), n, direction(cosine, 0), l) * cosine_l;
        }
      const double albedo = sum / rows * 2 * std::numbers::pi / columns;  // half the azimuths
      EXPECT_NEAR(albedo / table.at(lobes_of(m), cosine), 1, 0.03) << "m " << m << ", cos " << cosine;
    }
}

// Towards a light behind the point h goes to 0 and D F / h.h without bound: masking leaves D (1) / (4 cos
// Lambda) at most, where cos Lambda is m / 3.535 at the horizon.
TEST(SkinSpecular, IsBoundedTowardsALightBehind) {
  for (const double m : {0.2, 0.3, 0.5}) {
    const double bound = 0.18 / (m * m) * 3.535 / (4 * m);
    double largest = 0;
    for (const double cosine : {0.001, 0.02, 0.05, 0.1})
      for (int i = 0; i <= 400; ++i)
        for (int j = 0; j <= 40; ++j) {
          const glm::dvec3 l =
              direction(std::max(1e-3, std::pow(i / 400.0, 3)), std::numbers::pi * (1 - j / 400.0));
          const double reflected = specular_brdf(lobes_of(m), n, direction(cosine, 0), l) * l.z;
          ASSERT_TRUE(std::isfinite(reflected));
          largest = std::max(largest, reflected);
        }
    EXPECT_LE(largest, bound) << "m " << m;
    EXPECT_GE(largest, 0.1 * bound) << "m " << m;
  }
}

TEST(SkinSpecular, LightAndEyeCanChangePlaces) {
  const glm::dvec3 a = direction(0.07, 0.3), b = direction(0.8, 2);
  EXPECT_NEAR(specular_brdf(lobes_of(0.3), n, a, b), specular_brdf(lobes_of(0.3), n, b, a), 1e-12);
}

}  // namespace
}  // namespace dermis::reference
