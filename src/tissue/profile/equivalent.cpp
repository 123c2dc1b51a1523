// SPDX-License-Identifier: MIT
#include "tissue/profile/equivalent.h"

#include <algorithm>
#include <cmath>

#include "base/core/error.h"
#include "tissue/optics/inversion.h"
#include "tissue/profile/dipole.h"

namespace dermis::profile {

double half_frequency_per_mm(const RadialProfile& profile) {
  const double half = profile.hankel(0) / 2;
  // Bisection in log k: R^ falls with k.
  double low = std::log(1e-4 / profile.outer_mm()), high = std::log(1e5 / profile.inner_mm());
  for (int step = 0; step < 50; ++step) {
    const double middle = (low + high) / 2;
    (profile.hankel(std::exp(middle)) > half ? low : high) = middle;
  }
  return std::exp(low);
}

optics::Medium equivalent_medium(const RadialProfile& profile, double eta) {
  const double total = profile.total();
  if (!(total > 0)) throw input_error(profile.name(), "the profile reflects nothing");

  // The total gives the albedo. Above 1 - 1e-6 the diffuse mean free path diverges.
  const double albedo =
      optics::reduced_albedo_from_reflectance(std::min(total, 1 - 1e-6), eta, profile.name());

  // The half frequency gives the length: compared with that of a dipole whose mean free path is 1 mm.
  const Dipole unit({.sigma_a_per_mm = 1 - albedo, .sigma_s_per_mm = albedo, .g = 0, .eta = eta});
  const double length_mm = half_frequency_per_mm(unit) / half_frequency_per_mm(profile);
  return {
      .sigma_a_per_mm = (1 - albedo) / length_mm, .sigma_s_per_mm = albedo / length_mm, .g = 0, .eta = eta};
}

}  // namespace dermis::profile
