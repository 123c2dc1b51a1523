// SPDX-License-Identifier: MIT
#include "profile/beam.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "optics/fresnel.h"

namespace dermis::profile {

using std::numbers::pi;

BeamMultiple::BeamMultiple(const optics::Medium& medium) {
  constexpr int samples = 200;
  // 2 C1 and 3 C2.
  const double c1 = optics::fresnel_moment_2c1(medium.eta), c2 = optics::fresnel_moment_3c2(medium.eta);

  sigma_t_per_mm_ = medium.sigma_t_reduced_per_mm();
  albedo_ = medium.reduced_albedo();

  // Grosjean's D = (2 sigma_a + sigma_s') / (3 sigma_t'^2), and s = sqrt(sigma_a / D).
  diffusion_mm_ =
      (2 * medium.sigma_a_per_mm + medium.sigma_s_reduced_per_mm()) / (3 * sigma_t_per_mm_ * sigma_t_per_mm_);
  s_ = std::sqrt(medium.sigma_a_per_mm / diffusion_mm_);

  // Exitance from fluence and flux: C_phi = (1 - 2 C1) / 4, C_E = (1 - 3 C2) / 2.
  flux_part_ = (1 - c1) / 4;
  vector_part_ = (1 - c2) / 2;

  // A source at depth t has its image at the height t + 4 A D, A = (1 + 3 C2) / (1 - 2 C1).
  gap_mm_ = 4 * (1 + c2) / (1 - c1) * diffusion_mm_;

  // Depths of equal probability under sigma_t' e^{-sigma_t' t}, so that their plain mean is the integral.
  for (int i = 0; i < samples; ++i)
    depths_mm_.push_back(-std::log(1 - (i + 0.5) / samples) / sigma_t_per_mm_);
}

double BeamMultiple::at(double radius_mm) const {
  double sum = 0;
  for (const double t : depths_mm_) {
    const double z_image = t + gap_mm_;  // height above the surface
    const double d_r = std::hypot(radius_mm, t), d_v = std::hypot(radius_mm, z_image);
    const double e_r = std::exp(-s_ * d_r), e_v = std::exp(-s_ * d_v);

    // 4 pi times fluence phi and flux E_n of the dipole, [PBRT4].
    const double fluence = (e_r / d_r - e_v / d_v) / diffusion_mm_;
    const double flux =
        t * (1 + s_ * d_r) * e_r / (d_r * d_r * d_r) + z_image * (1 + s_ * d_v) * e_v / (d_v * d_v * d_v);

    // Diffusion is wrong near the source: [HCJ13]'s correction kappa = 1 - e^{-2 sigma_t' (d_r + t)}.
    const double kappa = -std::expm1(-2 * sigma_t_per_mm_ * (d_r + t));
    sum += (flux_part_ * fluence + vector_part_ * flux) * kappa;
  }
  return albedo_ * albedo_ / (4 * pi) * sum / static_cast<double>(depths_mm_.size());
}

double BeamMultiple::outer_mm() const {
  // Without absorption the tail is a power law: a thousand mean free paths hold nearly all of it.
  return s_ > 1e-3 * sigma_t_per_mm_ ? std::max(1 / s_, 1 / sigma_t_per_mm_) : 1000 / sigma_t_per_mm_;
}

double SingleScattering::at(double radius_mm) const {
  // [HCJ13] eq. 9: R(r) = Int_{t_c}^inf sigma_s e^{-sigma_t (t + d)} p_HG (1 - F(cos)) cos / d^2 dt,
  // with the depth t of the scattering, the way back d = sqrt(r^2 + t^2) and cos = t / d. From depths smaller
  // than t_c = r sqrt(eta^2 - 1) light meets the surface outside the escape cone.
  const double sigma_t = medium_.sigma_t_per_mm(), g = medium_.g;
  const double critical_mm = radius_mm * std::sqrt(medium_.eta * medium_.eta - 1);

  // Trapezoid rule in x = log(t - t_c), dt = (t - t_c) dx: the integrand is smooth and dies out at both ends.
  // It starts far inside the shorter of r and the mean free path, and ends where nothing is left.
  constexpr double step = 0.1;
  double sum = 0;
  for (double beyond = 1e-7 * std::min(radius_mm, 1 / sigma_t); beyond < 40 / sigma_t;
       beyond *= std::exp(step)) {
    const double t = critical_mm + beyond, d = std::hypot(radius_mm, t), cosine = t / d;

    // The beam goes down and the light comes up, so cos(theta) = -cos and the denominator of p_HG holds
    // 1 + g^2 + 2 g cos. Written so that nothing cancels for g near -1; 1 - cos = r^2 / (d (d + t)).
    const double turn = (1 + g) * (1 + g) - 2 * g * radius_mm * radius_mm / (d * (d + t));
    const double phase = (1 - g) * (1 + g) / (4 * pi * turn * std::sqrt(turn));

    sum += std::exp(-sigma_t * (t + d)) * phase * (1 - optics::fresnel(cosine, medium_.eta)) * cosine /
           (d * d) * beyond * step;
  }
  return medium_.sigma_s_per_mm * sum;
}

}  // namespace dermis::profile
