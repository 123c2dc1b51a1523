// SPDX-License-Identifier: MIT
// Profiles of a homogeneous half-space by a pair of sources: the light's own below the surface, its mirror
// image above. Based on: [JMLH01] Jensen, Marschner, Levoy, Hanrahan: A Practical Model for Subsurface Light
// Transport. SIGGRAPH 2001
//           [DI11] d'Eon, Irving: A Quantized-Diffusion Model for Rendering Translucent Materials. SIGGRAPH
//           2011 [DE12] d'Eon: A Better Dipole. 2012
#pragma once

#include "optics/media.h"
#include "profile/radial.h"

namespace dermis::profile {

/// Classical dipole [JMLH01] eq. 4 (in the form whose dimensions are right: z_v / d_v^3, not z_v / (sigma_t'
/// d_v^3)):
///   R(r) = alpha'/(4 pi) [ z_r (1 + s d_r) e^{-s d_r}/d_r^3 + z_v (1 + s d_v) e^{-s d_v}/d_v^3 ],  s =
///   sigma_tr, z_r = 1/sigma_t', z_v = z_r + 4 A D, d = sqrt(r^2 + z^2);   R^(k) = alpha'/2 [ e^{-z_r kappa}
///   + e^{-z_v kappa} ], kappa = sqrt(s^2 + k^2).
class Dipole final : public RadialProfile {
 public:
  /// medium as optics::check wants it. Without absorption the total is exactly 1 and the tail falls like
  /// 1/r^3.
  explicit Dipole(const optics::Medium& medium);

  double at(double radius_mm) const override;
  double hankel(double k_per_mm) const override;
  double inner_mm() const override { return z_real_mm_; }
  double outer_mm() const override;
  bool hankel_is_exact() const override { return true; }
  std::string name() const override { return "dipole"; }

 private:
  double reduced_albedo_;
  double sigma_tr_per_mm_;
  double z_real_mm_;
  double z_virtual_mm_;  // height above the surface
};

/// Better dipole [DE12]: Grosjean's diffusion coefficient and exitance from fluence and flux. Multiply
/// scattered light only: singly scattered light (profile/beam.h) is to be added by whoever needs it.
///   D = (2 sigma_a + sigma_s') / (3 sigma_t'^2), s = sqrt(sigma_a / D), C_phi = (1 - 2 C1)/4, C_E = (1 - 3
///   C2)/2, z_v = z_r + 4 A D, R^(k) = alpha'^2/2 { C_E (e^{-z_r kappa} + e^{-z_v kappa}) + C_phi/(D kappa)
///   (e^{-z_r kappa} - e^{-z_v kappa}) }.
class BetterDipole final : public RadialProfile {
 public:
  /// medium as optics::check wants it.
  explicit BetterDipole(const optics::Medium& medium);

  double at(double radius_mm) const override;
  double hankel(double k_per_mm) const override;
  double inner_mm() const override { return z_real_mm_; }
  double outer_mm() const override;
  bool hankel_is_exact() const override { return true; }
  std::string name() const override { return "better dipole"; }

 private:
  double reduced_albedo_;
  double diffusion_mm_;
  double sigma_tr_per_mm_;
  double flux_part_;    // C_phi
  double vector_part_;  // C_E
  double z_real_mm_;
  double z_virtual_mm_;
};

}  // namespace dermis::profile
