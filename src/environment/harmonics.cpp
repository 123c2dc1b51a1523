// SPDX-License-Identifier: MIT
#include "environment/harmonics.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "environment/environment.h"

namespace dermis::environment {
namespace {

using std::numbers::pi;
constexpr int order = harmonic_order;

/// Zonal factors of the cosine lobe by order, [RH01] eq. 8.
constexpr std::array<double, order + 1> zonal{pi, 2 * pi / 3, pi / 4, 0, -pi / 24, 0};

const std::array<double, harmonic_terms>& norms() {
  static const std::array<double, harmonic_terms> table = [] {
    std::array<double, harmonic_terms> made{};
    for (int l = 0; l <= order; ++l)
      for (int m = -l; m <= l; ++m) made[harmonic_number(l, m)] = harmonic_norm(l, std::abs(m));
    return made;
  }();
  return table;
}

}  // namespace

double harmonic_norm(int l, int m) {
  double factorials = 1;
  for (int i = l - m + 1; i <= l + m; ++i) factorials *= i;
  return std::sqrt((m > 0 ? 2 : 1) * (2 * l + 1) / (4 * pi) / factorials);
}

Harmonics harmonics(const glm::dvec3& d) {
  Harmonics out{};
  // Real and imaginary part of (z + i x)^m: sin(polar)^m times cosine and sine of m azimuths.
  double cosine = 1, sine = 0;
  double diagonal = 1;  // the Legendre function P_m^m without sin^m: 1 3 5 ... (2 m - 1)
  for (int m = 0; m <= order; ++m) {
    double before = 0, here = diagonal;
    for (int l = m; l <= order; ++l) {
      out[harmonic_number(l, m)] = norms()[harmonic_number(l, m)] * here * cosine;
      if (m > 0) out[harmonic_number(l, -m)] = norms()[harmonic_number(l, m)] * here * sine;
      // (l - m + 1) P_{l+1}^m = (2 l + 1) y P_l^m - (l + m) P_{l-1}^m.
      const double next = (d.y * (2 * l + 1) * here - (l + m) * before) / (l - m + 1);
      before = here;
      here = next;
    }
    diagonal *= 2 * m + 1;
    const double turned_cosine = cosine * d.z - sine * d.x;
    sine = cosine * d.x + sine * d.z;
    cosine = turned_cosine;
  }
  return out;
}

Harmonics cosine_lobe(const glm::dvec3& normal) {
  Harmonics lobe = harmonics(normal);
  for (int l = 0; l <= order; ++l)
    for (int m = -l; m <= l; ++m) lobe[harmonic_number(l, m)] *= zonal[static_cast<std::size_t>(l)];
  return lobe;
}

SkyHarmonics sky_of(const image::ImageF& picture) {
  SkyHarmonics sky{};
  double solid_angle = 0;
  // Sums L Y over the pixels, weighted by solid angle, and scales to the whole sphere, 4 pi sr.
  for (int y = 0; y < picture.height; ++y) {
    const double v = (y + 0.5) / picture.height, share = std::sin(pi * v);
    for (int x = 0; x < picture.width; ++x) {
      const float* rgb = picture.at(x, y);
      const Harmonics basis = harmonics(direction_of((x + 0.5) / picture.width, v));
      for (std::size_t k = 0; k < sky.size(); ++k)
        sky[k] += glm::dvec3(rgb[0], rgb[1], rgb[2]) * (basis[k] * share);
      solid_angle += share;
    }
  }
  for (glm::dvec3& value : sky) value *= 4 * pi / solid_angle;
  return sky;
}

glm::dvec3 irradiance_of(const SkyHarmonics& sky, const glm::dvec3& normal, int highest) {
  const Harmonics lobe = cosine_lobe(normal);
  glm::dvec3 sum(0);
  for (std::size_t k = 0; k < harmonic_number(highest, highest) + 1; ++k) sum += sky[k] * lobe[k];
  return sum;
}

namespace {

// Returns the terms of order l divided by 1 + lambda l^2 (l + 1)^2, [S08].
SkyHarmonics windowed(const SkyHarmonics& sky, double lambda) {
  SkyHarmonics out = sky;
  for (int l = 1; l <= order; ++l)
    for (int m = -l; m <= l; ++m) out[harmonic_number(l, m)] /= 1 + lambda * l * l * (l + 1) * (l + 1);
  return out;
}

/// Returns whether irradiance is below 0 in one of a set of directions 4 degrees apart, a ninth of what order
/// 5 resolves.
bool rings(const SkyHarmonics& sky) {
  constexpr int directions = 2600;
  for (int i = 0; i < directions; ++i) {
    const double y = 1 - (2 * i + 1.0) / directions, across = std::sqrt(1 - y * y);
    const double azimuth = i * pi * (3 - std::sqrt(5.0));  // the golden angle
    const glm::dvec3 e = irradiance_of(sky, {across * std::cos(azimuth), y, across * std::sin(azimuth)});
    if (std::min({e.x, e.y, e.z}) < 0) return true;
  }
  return false;
}

}  // namespace

SkyHarmonics without_ringing(const SkyHarmonics& sky) {
  if (!rings(sky)) return sky;

  // Bisection for the smallest lambda. At lambda = 1 only the mean and a fifth of order 1 remain, even of a
  // point of light.
  double low = 0, high = 1;
  for (int i = 0; i < 12; ++i) {
    const double middle = (low + high) / 2;
    (rings(windowed(sky, middle)) ? low : high) = middle;
  }
  return windowed(sky, high);
}

SkyHarmonics turned(const SkyHarmonics& sky, double angle_rad) {
  SkyHarmonics out = sky;
  for (int m = 1; m <= order; ++m) {
    const double c = std::cos(m * angle_rad), s = std::sin(m * angle_rad);
    for (int l = m; l <= order; ++l) {
      const glm::dvec3 &cosine = sky[harmonic_number(l, m)], &sine = sky[harmonic_number(l, -m)];
      out[harmonic_number(l, m)] = cosine * c - sine * s;
      out[harmonic_number(l, -m)] = cosine * s + sine * c;
    }
  }
  return out;
}

// Projects onto the turned harmonics. Products of two of them have degree 10 at most, which six points of
// Gauss and Legendre times twelve azimuths integrate exactly.
SkyHarmonics seen_from(const SkyHarmonics& sky, const glm::dmat3& world_from_own) {
  static_assert(order == 5);
  constexpr std::array<double, 6> heights{-0.9324695142031521, -0.6612093864662645, -0.2386191860831969,
                                          0.2386191860831969,  0.6612093864662645,  0.9324695142031521};
  constexpr std::array<double, 6> shares{0.1713244923791704, 0.3607615730481386, 0.4679139345726910,
                                         0.4679139345726910, 0.3607615730481386, 0.1713244923791704};
  constexpr int azimuths = 12;

  SkyHarmonics out{};
  for (std::size_t i = 0; i < heights.size(); ++i)
    for (int k = 0; k < azimuths; ++k) {
      const double azimuth = 2 * pi * k / azimuths, across = std::sqrt(1 - heights[i] * heights[i]);
      const glm::dvec3 own(across * std::sin(azimuth), heights[i], across * std::cos(azimuth));

      glm::dvec3 radiance(0);
      const Harmonics world = harmonics(world_from_own * own), here = harmonics(own);
      for (std::size_t j = 0; j < sky.size(); ++j) radiance += sky[j] * world[j];
      for (std::size_t j = 0; j < out.size(); ++j)
        out[j] += radiance * (here[j] * shares[i] * 2 * pi / azimuths);
    }
  return out;
}

}  // namespace dermis::environment
