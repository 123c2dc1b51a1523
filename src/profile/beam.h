// SPDX-License-Identifier: MIT
// Photon beam diffusion: the light that enters is a line of sources instead of one point. Light scattered
// once is computed exactly. Based on: [HCJ13] Habel, Christensen, Jarosz: Photon Beam Diffusion: A Hybrid
// Monte Carlo Method for Subsurface
//         Scattering. EGSR 2013
// [PBRT4] Pharr, Jakob, Humphreys: pbrt-v4, bssrdf.cpp (this discretisation, there with 100 depths, whose
// total
//         is 1e-4 off)
#pragma once

#include <algorithm>
#include <string>
#include <vector>

#include "optics/media.h"
#include "profile/radial.h"

namespace dermis::profile {

/// Light scattered more than once: the mean of dipoles at 200 depths along the refracted beam, with [HCJ13]'s
/// correction kappa near the source. [HCJ13] sec. 4, in [PBRT4]'s form.
class BeamMultiple final : public RadialProfile {
 public:
  /// Takes a medium that passes optics::check. Scattering counts as reduced; without any, the profile is 0.
  explicit BeamMultiple(const optics::Medium& medium);
  double at(double radius_mm) const override;
  double inner_mm() const override { return 1 / sigma_t_per_mm_; }
  double outer_mm() const override;
  std::string name() const override { return "photon beam diffusion, multiple scattering"; }

 private:
  double sigma_t_per_mm_, albedo_, diffusion_mm_, s_, flux_part_, vector_part_, gap_mm_;  // 4 A D
  std::vector<double> depths_mm_;
};

/// Light scattered exactly once, for a perpendicular beam. [HCJ13] eq. 9. Grows like 1/r towards r = 0. Uses
/// the true sigma_s and g.
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

/// The sum of both.
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
