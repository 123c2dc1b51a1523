// SPDX-License-Identifier: MIT
#include "truth/reference/shape_prediction.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "base/core/error.h"
#include "tissue/profile/shape_laws.h"

namespace dermis::reference {
namespace {

using std::numbers::pi;

constexpr int most_degree = 60;  // the clamped cosine falls as 1 / degree^2

/// Coefficient of the clamped cosine in Legendre polynomials (Ramamoorthi and Hanrahan: On the relationship
/// between radiance and irradiance. JOSA A 18, 2001): max(cos, 0) = sum c_l P_l(cos).
double sphere_coefficient(int l) {
  if (l == 1) return 0.5;
  if (l % 2 == 1) return 0;
  // (2 l + 1) / 2 (-1)^(l/2 - 1) / ((l + 2) (l - 1)) * C(l, l/2) / 2^l, by a running product
  double binomial = 1;
  for (int i = 1; i <= l / 2; ++i) binomial *= (i - 0.5) / i;
  return (l + 0.5) * (l / 2 % 2 == 1 ? 1.0 : -1.0) / ((l + 2) * (l - 1.0)) * binomial;
}

/// The same in cosines of multiples of the angle.
double cylinder_coefficient(int m) {
  if (m == 0) return 1 / pi;
  if (m == 1) return 0.5;
  if (m % 2 == 1) return 0;
  return 2 / pi * (m / 2 % 2 == 1 ? 1.0 : -1.0) / (m * m - 1.0);
}

/// Sum of coefficient times function times what the profile keeps of waves of this number per mm squared.
template <class Coefficient, class Wave>
optics::Rgb sum_of_waves(const ScatterProfile& profile, const Coefficient& coefficient, const Wave& wave) {
  optics::Rgb sum{};
  for (int i = 0; i <= most_degree; ++i) {
    const auto [value, k2_per_mm2] = wave(i);
    for (std::size_t c = 0; c < 3; ++c) {
      double kept = 0;
      for (const Gaussian& term : profile.terms)
        kept += term.weight[c] * std::exp(-0.5 * term.variance_mm2 * k2_per_mm2);
      sum[c] += coefficient(i) * value * kept;
    }
  }
  return sum;
}

}  // namespace

optics::Rgb blurred(const Body& body, const ScatterProfile& profile, double light_deg) {
  const double angle = light_deg * pi / 180, cosine = std::cos(angle), r2 = body.size_mm * body.size_mm;
  switch (body.shape) {
    case Shape::sphere:
    case Shape::bowl:
      return sum_of_waves(profile, sphere_coefficient, [&](int l) {
        return std::pair(std::legendre(static_cast<unsigned>(l), cosine), l * (l + 1) / r2);
      });
    case Shape::cylinder:
    case Shape::groove:
      return sum_of_waves(profile, cylinder_coefficient,
                          [&](int m) { return std::pair(std::cos(m * angle), m * m / r2); });
    default: {
      const double lit = body.shape == Shape::slab ? std::abs(cosine) : std::max(cosine, 0.0);
      return {lit, lit, lit};
    }
  }
}

optics::Rgb shape_factor(const Body& body, const ScatterProfile& profile, double light_deg) {
  if (!profile.shape || !profile.medium)
    throw input_error(profile.name, "this profile does not say what medium it is of");

  const ShapeLaws& laws = *profile.shape;
  const optics::RgbMedium medium = optics::rgb_medium(*profile.medium);
  const double k = 1 / body.size_mm;
  optics::Rgb factor{1, 1, 1};
  for (std::size_t c = 0; c < 3; ++c) {
    switch (body.shape) {
      case Shape::sphere: factor[c] = profile::curved_total(laws, c, k, 0); break;
      case Shape::bowl: factor[c] = profile::curved_total(laws, c, -k, 0); break;
      case Shape::cylinder: factor[c] = profile::curved_total(laws, c, k / 2, k / 2); break;
      case Shape::groove: factor[c] = profile::curved_total(laws, c, -k / 2, k / 2); break;
      case Shape::saddle: factor[c] = profile::curved_total(laws, c, 0, k); break;
      case Shape::slab:
        factor[c] = std::cos(light_deg * pi / 180) >= 0
                        ? profile::slab_front(laws, c, body.size_mm)
                        : profile::slab_backs(medium[c], std::span(&body.size_mm, 1)).front();
        break;
      case Shape::wedge: break;
    }
  }
  return factor;
}

}  // namespace dermis::reference
