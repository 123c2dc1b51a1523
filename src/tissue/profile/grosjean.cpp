// SPDX-License-Identifier: MIT
#include "tissue/profile/grosjean.h"

#include <cmath>

#include "tissue/optics/fresnel.h"

namespace dermis::profile {

GrosjeanDiffusion::GrosjeanDiffusion(const optics::Medium& medium)
    : sigma_t_reduced_per_mm(medium.sigma_t_reduced_per_mm()), reduced_albedo(medium.reduced_albedo()) {
  // Grosjean's diffusion coefficient D = (2 sigma_a + sigma_s') / (3 sigma_t'^2), and the effective transport
  // coefficient sigma_tr = sqrt(sigma_a / D).
  const double sigma_t = sigma_t_reduced_per_mm;
  coefficient_mm = (2 * medium.sigma_a_per_mm + medium.sigma_s_reduced_per_mm()) / (3 * sigma_t * sigma_t);
  sigma_tr_per_mm = std::sqrt(medium.sigma_a_per_mm / coefficient_mm);

  // Exitance from fluence and flux at the surface: C_phi = (1 - 2 C1) / 4, C_E = (1 - 3 C2) / 2.
  const double two_c1 = optics::fresnel_moment_2c1(medium.eta);
  const double three_c2 = optics::fresnel_moment_3c2(medium.eta);
  fluence_part = (1 - two_c1) / 4;
  flux_part = (1 - three_c2) / 2;

  // Boundary: a source at depth z has its image at the height z + 4 A D, A = (1 + 3 C2) / (1 - 2 C1),
  // [DI11] eq. 25.
  gap_mm = 4 * (1 + three_c2) / (1 - two_c1) * coefficient_mm;
}

}  // namespace dermis::profile
