// SPDX-License-Identifier: MIT
// Photon beam diffusion: a narrow beam enters the skin and scatters all along its way, so the light has a
// line of sources instead of one point. Light scattered once is computed exactly, the rest by diffusion.
// Based on:
// [HCJ13] Habel, Christensen, Jarosz: Photon Beam Diffusion: A Hybrid Monte Carlo Method for Subsurface
//         Scattering. EGSR 2013
// [PBRT4] Pharr, Jakob, Humphreys: pbrt-v4, bssrdf.cpp (the form of the sums)
//
// Departs from [PBRT4]: 200 depths instead of 100, whose total is 1e-4 off. Light scattered once is
// integrated over the logarithm of the depth, which keeps its accuracy near the beam.
#pragma once

#include <algorithm>
#include <string>
#include <vector>

#include "tissue/optics/media.h"
#include "tissue/profile/grosjean.h"
#include "tissue/profile/radial.h"

namespace dermis::profile {

/// Light scattered more than once: the mean of dipoles at 200 depths along the beam, which enters
/// perpendicularly, with [HCJ13]'s correction kappa near the source. [HCJ13] sec. 4, in [PBRT4]'s form.
class BeamMultiple final : public RadialProfile {
 public:
  /// Takes a medium that passes optics::check. Uses sigma_s' only, as diffusion does; without scattering the
  /// profile is 0.
  explicit BeamMultiple(const optics::Medium& medium);
  double at(double radius_mm) const override;
  double inner_mm() const override { return 1 / diffusion_.sigma_t_reduced_per_mm; }
  double outer_mm() const override;
  std::string name() const override { return "photon beam diffusion, multiple scattering"; }

 private:
  GrosjeanDiffusion diffusion_;
  std::vector<double> depths_mm_;  // of the sources
};

/// Light scattered exactly once, for a perpendicular beam. [HCJ13] eq. 9. Uses the true sigma_s and g. Grows
/// like 1/r towards r = 0.
class SingleScattering final : public RadialProfile {
 public:
  /// Takes a medium that passes optics::check.
  explicit SingleScattering(const optics::Medium& medium) : medium_(medium) {}
  double at(double radius_mm) const override;
  /// A backward lobe (g < 0) returns light within about 1 + g mean free paths.
  double inner_mm() const override { return std::min(1.0, 1 + medium_.g) / medium_.sigma_t_per_mm(); }
  double outer_mm() const override { return 1 / medium_.sigma_t_per_mm(); }
  bool has_pole() const override { return true; }
  std::string name() const override { return "single scattering"; }

 private:
  optics::Medium medium_;
};

/// The whole profile: BeamMultiple plus SingleScattering.
class PhotonBeam final : public RadialProfile {
 public:
  /// Takes a medium that passes optics::check.
  explicit PhotonBeam(const optics::Medium& medium) : multiple_(medium), single_(medium) {}
  double at(double radius_mm) const override { return multiple_.at(radius_mm) + single_.at(radius_mm); }
  double inner_mm() const override { return std::min(multiple_.inner_mm(), single_.inner_mm()); }
  double outer_mm() const override { return multiple_.outer_mm(); }
  bool has_pole() const override { return true; }
  std::string name() const override { return "photon beam diffusion"; }

 private:
  BeamMultiple multiple_;
  SingleScattering single_;
};

}  // namespace dermis::profile
