// SPDX-License-Identifier: MIT
// Light scattered more than once as Grosjean's diffusion sees it: what sources below a surface and their
// mirror images above it send out.
// Based on:
// [DE12]  d'Eon: A Better Dipole. 2012
// [DI11]  d'Eon, Irving: A Quantized-Diffusion Model for Rendering Translucent Materials. SIGGRAPH 2011
// [HCJ13] Habel, Christensen, Jarosz: Photon Beam Diffusion: A Hybrid Monte Carlo Method for Subsurface
//         Scattering. EGSR 2013
#pragma once

#include "tissue/optics/media.h"

namespace dermis::profile {

struct GrosjeanDiffusion {
  /// Takes a medium that passes optics::check.
  explicit GrosjeanDiffusion(const optics::Medium& medium);

  double sigma_t_reduced_per_mm;
  double reduced_albedo;
  double coefficient_mm;   ///< D
  double sigma_tr_per_mm;  ///< sqrt(sigma_a / D)
  double fluence_part;     ///< C_phi: what part of the fluence at the surface leaves
  double flux_part;        ///< C_E: what part of the flux through the surface leaves
  double gap_mm;           ///< 4 A D: how much higher an image lies than its source is deep
};

}  // namespace dermis::profile
