// SPDX-License-Identifier: MIT
#include "environment/harmonics.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "environment/environment.h"

namespace dermis::environment {
namespace {

using std::numbers::pi;

// Over the sphere, in steps whose sum is exact for polynomials of this degree in all but rounding of the
// steps.
template <class F>
void over_the_sphere(F&& f) {
  constexpr int rows = 160;
  for (int y = 0; y < rows; ++y)
    for (int x = 0; x < 2 * rows; ++x) {
      const double v = (y + 0.5) / rows;
      f(direction_of((x + 0.5) / (2 * rows), v), std::sin(pi * v) * pi * pi / (rows * rows));
    }
}

TEST(Harmonics, AreOrthonormal) {
  std::array<std::array<double, harmonic_terms>, harmonic_terms> product{};
  over_the_sphere([&](const glm::dvec3& d, double weight) {
    const Harmonics y = harmonics(d);
    for (std::size_t i = 0; i < harmonic_terms; ++i)
      for (std::size_t j = 0; j <= i; ++j) product[i][j] += weight * y[i] * y[j];
  });
  for (std::size_t i = 0; i < harmonic_terms; ++i)
    for (std::size_t j = 0; j <= i; ++j) EXPECT_NEAR(product[i][j], i == j ? 1 : 0, 1e-3) << i << " " << j;
}

TEST(Harmonics, CosineLobeIsTheIntegral) {
  for (const glm::dvec3& n :
       {glm::dvec3(0, 1, 0), glm::dvec3(0, 0, 1), glm::normalize(glm::dvec3(1, -2, 0.5))}) {
    Harmonics sum{};
    over_the_sphere([&](const glm::dvec3& d, double weight) {
      const Harmonics y = harmonics(d);
      for (std::size_t k = 0; k < y.size(); ++k) sum[k] += weight * y[k] * std::max(0.0, glm::dot(n, d));
    });
    const Harmonics lobe = cosine_lobe(n);
    for (std::size_t k = 0; k < lobe.size(); ++k) EXPECT_NEAR(lobe[k], sum[k], 2e-3) << k;
  }
}

// Order 5 is all that a cubic polynomial needs: projected and summed again it is itself, also when turned.
TEST(Harmonics, HoldAPolynomialAndTurnIt) {
  const auto radiance = [](const glm::dvec3& d) {
    return glm::dvec3(2 + d.x, 1 + d.x * d.z + d.y, 1.5 + d.z * d.z * d.x - d.y * d.y);
  };

  image::ImageF picture{.width = 256, .height = 128, .channels = 3, .values = {}};
  for (int y = 0; y < picture.height; ++y)
    for (int x = 0; x < picture.width; ++x) {
      const glm::dvec3 rgb = radiance(direction_of((x + 0.5) / picture.width, (y + 0.5) / picture.height));
      for (int c = 0; c < 3; ++c) picture.values.push_back(static_cast<float>(rgb[c]));
    }
  const SkyHarmonics sky = sky_of(picture), left = turned(sky, pi / 2);

  const auto evaluate = [](const SkyHarmonics& s, const glm::dvec3& d) {
    const Harmonics y = harmonics(d);
    glm::dvec3 sum(0);
    for (std::size_t k = 0; k < y.size(); ++k) sum += s[k] * y[k];
    return sum;
  };

  for (int i = 0; i < 40; ++i) {
    const double z = 1 - (2 * i + 1) / 40.0, a = 2.4 * i;
    const glm::dvec3 d(std::sqrt(1 - z * z) * std::cos(a), std::sqrt(1 - z * z) * std::sin(a), z);
    EXPECT_LT(glm::length(evaluate(sky, d) - radiance(d)), 2e-3);
    // What was in front (+Z) is now at the left (+X).
    EXPECT_LT(glm::length(evaluate(left, d) - radiance({-d.z, d.y, d.x})), 2e-3);
  }
}

}  // namespace
}  // namespace dermis::environment
