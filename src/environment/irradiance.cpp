// SPDX-License-Identifier: MIT
#include <algorithm>
#include <cmath>
#include <numbers>

#include "environment/environment.h"

namespace dermis::environment {
namespace {

using Basis = std::array<double, 9>;

// The polynomials of Irradiance, without their factors.
Basis polynomials(const glm::dvec3& n) {
  return {1, n.y, n.z, n.x, n.x * n.y, n.y * n.z, 3 * n.z * n.z - 1, n.x * n.z, n.x * n.x - n.y * n.y};
}

// Squared norms of the harmonics: Y = k * polynomial, so projection onto Y and evaluation multiply by k^2.
using std::numbers::pi;
constexpr Basis squared_factors{1 / (4 * pi),  3 / (4 * pi),  3 / (4 * pi),  3 / (4 * pi),  15 / (4 * pi),
                                15 / (4 * pi), 5 / (16 * pi), 15 / (4 * pi), 15 / (16 * pi)};
// Factors of the cosine lobe per order: pi, 2 pi / 3, pi / 4.
constexpr Basis cosine_factors{pi,     2 * pi / 3, 2 * pi / 3, 2 * pi / 3, pi / 4,
                               pi / 4, pi / 4,     pi / 4,     pi / 4};

}  // namespace

Irradiance irradiance_of(const Environment& environment) {
  const image::ImageF& picture = environment.radiance;
  // Samples each pixel of a small picture several times, because the polynomials vary within it.
  const int nx = std::max(1, 128 / picture.width), ny = std::max(1, 64 / picture.height);

  Irradiance sum{};
  double solid_angle = 0;
  for (int y = 0; y < picture.height * ny; ++y) {
    const double v = (y + 0.5) / (picture.height * ny), share = std::sin(pi * v);
    for (int x = 0; x < picture.width * nx; ++x) {
      const float* rgb = picture.at(x / nx, y / ny);
      const Basis p = polynomials(direction_of((x + 0.5) / (picture.width * nx), v));
      for (std::size_t k = 0; k < sum.size(); ++k)
        sum[k] += glm::dvec3(rgb[0], rgb[1], rgb[2]) * (p[k] * share);
      solid_angle += share;
    }
  }

  // Scales the sums to the whole sphere, 4 pi sr, and each term to irradiance.
  for (std::size_t k = 0; k < sum.size(); ++k)
    sum[k] *= squared_factors[k] * cosine_factors[k] * 4 * pi / solid_angle;
  return sum;
}

glm::dvec3 evaluate(const Irradiance& irradiance, const glm::dvec3& normal) {
  const Basis p = polynomials(normal);
  glm::dvec3 e(0);
  for (std::size_t k = 0; k < p.size(); ++k) e += irradiance[k] * p[k];
  return glm::max(e, glm::dvec3(0));
}

}  // namespace dermis::environment
