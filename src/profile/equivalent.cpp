// SPDX-License-Identifier: MIT
#include "profile/equivalent.h"

#include <algorithm>
#include <cmath>

#include "core/error.h"
#include "optics/fresnel.h"
#include "optics/inversion.h"

namespace dermis::profile {

double mean_square_radius_mm2(const RadialProfile& profile) {
  const double k = 3e-3 / profile.outer_mm();
  return 4 * (1 - profile.hankel(k) / profile.hankel(0)) / (k * k);
}

optics::Medium equivalent_medium(const RadialProfile& profile, double eta) {
  const double total = profile.total();
  if (!(total > 0)) throw input_error(profile.name(), "the profile reflects nothing");
  // Above 1 - 1e-6 the diffuse mean free path diverges and <r^2> with it.
  const double albedo = optics::reduced_albedo_from_reflectance(std::min(total, 1 - 1e-6), eta, profile.name());
  // <r^2> of the dipole with sigma_t' = 1: (2/s) (z_r e^{-s z_r} + z_v e^{-s z_v}) / (e^{-s z_r} + e^{-s z_v})
  const double s = std::sqrt(3 * (1 - albedo)), z_real = 1, z_image = 1 + 4.0 / 3 * optics::boundary_factor_classical(eta);
  const double real = std::exp(-s * z_real), image = std::exp(-s * z_image);
  const double unit = 2 / s * (z_real * real + z_image * image) / (real + image);
  const double length_mm = std::sqrt(std::max(mean_square_radius_mm2(profile), 1e-18) / unit);
  return {.sigma_a_per_mm = (1 - albedo) / length_mm, .sigma_s_per_mm = albedo / length_mm, .g = 0, .eta = eta};
}

}  // namespace dermis::profile
