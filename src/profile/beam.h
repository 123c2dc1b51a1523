// SPDX-License-Identifier: MIT
// Photon beam diffusion: the light that enters as a line of sources instead of one point, and what scatters
// just once, exactly. Based on: [HCJ13] Habel, Christensen, Jarosz: Photon Beam Diffusion: A Hybrid Monte
// Carlo Method for Subsurface Scattering. EGSR 2013
//           [PBRT4] Pharr, Jakob, Humphreys: pbrt-v4, bssrdf.cpp (the discretisation that these follow; 100
//           depths there, whose total is 1e-4 off)
#pragma once

#include <algorithm>
#include <string>
#include <vector>

#include "optics/media.h"
#include "profile/radial.h"

namespace dermis::profile {

/// Light scattered more than once. Mean over 200 depths t_i = -ln(1 - (i + 1/2)/200) / sigma_t' of
///   alpha'^2 (C_phi phi + C_E E_n) kappa,  kappa = 1 - e^{-2 sigma_t' (d_r + t)},
///   phi = (e^{-s d_r}/d_r - e^{-s d_v}/d_v) / (4 pi D), E_n = [ t (1 + s d_r) e^{-s d_r}/d_r^3 - z_v (1 + s
///   d_v) e^{-s d_v}/d_v^3 ] / (4 pi),
/// Grosjean's D = (2 sigma_a + sigma_s')/(3 sigma_t'^2), z_v = -t - 4 A D, A = (1 + 3 C2)/(1 - 2 C1). [HCJ13]
/// sec. 4, in [PBRT4]'s form.
class BeamMultiple final : public RadialProfile {
 public:
  /// medium as optics::check wants it; scattering counts as reduced, and without any the profile is 0.
  explicit BeamMultiple(const optics::Medium& medium);
  double at(double radius_mm) const override;
  double inner_mm() const override { return 1 / sigma_t_per_mm_; }
  double outer_mm() const override;
  std::string name() const override { return "photon beam diffusion, multiple scattering"; }

 private:
  double sigma_t_per_mm_, albedo_, diffusion_mm_, s_, flux_part_, vector_part_, gap_mm_;  // gap: 4 A D
  std::vector<double> depths_mm_;
};

/// Light scattered exactly once, beam perpendicular, exit inside the escape cone (depth t > t_c = r
/// sqrt(eta^2 - 1)):
///   R(r) = Int_{t_c}^inf sigma_s e^{-sigma_t (t + d)} p_HG (1 - F(cos)) cos / d^2 dt,  d = sqrt(r^2 + t^2),
///   cos = t/d. [HCJ13] eq. 9.
/// Grows like 1/r towards r = 0. Uses the true sigma_s and g.
class SingleScattering final : public RadialProfile {
 public:
  /// medium as optics::check wants it.
  explicit SingleScattering(const optics::Medium& medium) : medium_(medium) {}
  double at(double radius_mm) const override;
  /// A backward lobe (g < 0) throws light back within about 1 + g of a mean free path.
  double inner_mm() const override { return std::min(1.0, 1 + medium_.g) / medium_.sigma_t_per_mm(); }
  double outer_mm() const override { return 1 / medium_.sigma_t_per_mm(); }
  bool has_pole() const override { return true; }
  std::string name() const override { return "single scattering"; }

 private:
  optics::Medium medium_;
};

/// Both together.
class PhotonBeam final : public RadialProfile {
 public:
  /// medium as optics::check wants it.
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
