// SPDX-License-Identifier: MIT
#include "tissue/profile/beam.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "tissue/optics/fresnel.h"

namespace dermis::profile {

using std::numbers::pi;

BeamMultiple::BeamMultiple(const optics::Medium& medium) : diffusion_(medium) {
  // Depths of equal probability under sigma_t' e^{-sigma_t' t}, so that their plain mean is the integral.
  constexpr int samples = 200;
  for (int i = 0; i < samples; ++i)
    depths_mm_.push_back(-std::log(1 - (i + 0.5) / samples) / diffusion_.sigma_t_reduced_per_mm);
}

double BeamMultiple::at(double radius_mm) const {
  const double s = diffusion_.sigma_tr_per_mm, sigma_t = diffusion_.sigma_t_reduced_per_mm;
  double sum = 0;

  for (const double t : depths_mm_) {
    // Dipole: a real source at depth t, its image at height z_v. Distances d [mm] and decays e of both.
    const double z_v = t + diffusion_.gap_mm;
    const double d_r = std::hypot(radius_mm, t), d_v = std::hypot(radius_mm, z_v);
    const double e_r = std::exp(-s * d_r), e_v = std::exp(-s * d_v);

    // Fluence phi of the dipole, times 4 pi: [e_r / d_r - e_v / d_v] / D. [PBRT4]
    const double fluence = (e_r / d_r - e_v / d_v) / diffusion_.coefficient_mm;

    // Flux E_n through the surface, times 4 pi: the sum of z (1 + s d) e / d^3 over both. [PBRT4]
    const double flux =
        t * (1 + s * d_r) * e_r / (d_r * d_r * d_r) + z_v * (1 + s * d_v) * e_v / (d_v * d_v * d_v);

    // Diffusion is wrong near the source: [HCJ13]'s correction kappa = 1 - e^{-2 sigma_t' (d_r + t)}.
    const double kappa = -std::expm1(-2 * sigma_t * (d_r + t));
    sum += (diffusion_.fluence_part * fluence + diffusion_.flux_part * flux) * kappa;
  }

  // Mean over the depths. One alpha' is the first scattering, which makes the source; the other is
  // Grosjean's, for light that scatters again.
  const double albedo = diffusion_.reduced_albedo;
  return albedo * albedo / (4 * pi) * sum / static_cast<double>(depths_mm_.size());
}

double BeamMultiple::outer_mm() const {
  // Without absorption the tail is a power law: a thousand mean free paths hold nearly all of it.
  const double sigma_tr = diffusion_.sigma_tr_per_mm, sigma_t = diffusion_.sigma_t_reduced_per_mm;
  return sigma_tr > 1e-3 * sigma_t ? std::max(1 / sigma_tr, 1 / sigma_t) : 1000 / sigma_t;
}

double SingleScattering::at(double radius_mm) const {
  // [HCJ13] eq. 9:
  //   R(r) = Int_{t_c}^inf sigma_s e^{-sigma_t (t + d)} p_HG (1 - F(cos)) cos / d^2 dt
  // with the depth t of the scattering, the way back d = sqrt(r^2 + t^2) and cos = t / d.
  const double sigma_t = medium_.sigma_t_per_mm(), g = medium_.g;

  // From depths smaller than t_c = r sqrt(eta^2 - 1) light meets the surface outside the escape cone.
  const double critical_mm = radius_mm * std::sqrt(medium_.eta * medium_.eta - 1);

  // Trapezoid rule in x = log(t - t_c), dt = (t - t_c) dx: the integrand is smooth and vanishes at both ends.
  // The sum begins at 1e-7 of the shorter of r and the mean free path, and ends after 40 mean free paths.
  constexpr double step = 0.1;
  double sum = 0;
  for (double beyond_mm = 1e-7 * std::min(radius_mm, 1 / sigma_t); beyond_mm < 40 / sigma_t;
       beyond_mm *= std::exp(step)) {
    const double t = critical_mm + beyond_mm;
    const double d = std::hypot(radius_mm, t);
    const double cosine = t / d;

    // Henyey-Greenstein: p_HG = (1 - g^2) / (4 pi h^{3/2}), h = 1 + g^2 - 2 g cos(theta).
    // The beam goes down and the light comes up, so cos(theta) = -cos. Nothing cancels for g near -1 in
    // h = (1 + g)^2 - 2 g (1 - cos), where 1 - cos = r^2 / (d (d + t)).
    const double h = (1 + g) * (1 + g) - 2 * g * radius_mm * radius_mm / (d * (d + t));
    const double phase = (1 - g) * (1 + g) / (4 * pi * h * std::sqrt(h));

    // The integrand without sigma_s, times dt.
    sum += std::exp(-sigma_t * (t + d)) * phase * (1 - optics::fresnel(cosine, medium_.eta)) * cosine /
           (d * d) * beyond_mm * step;
  }
  return medium_.sigma_s_per_mm * sum;
}

}  // namespace dermis::profile
