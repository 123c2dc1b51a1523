// SPDX-License-Identifier: MIT
// Profiles of a homogeneous half-space by a pair of point sources: the real one below the surface, its mirror
// image above.
// Based on:
// [JMLH01] Jensen, Marschner, Levoy, Hanrahan: A Practical Model for Subsurface Light Transport.
//          SIGGRAPH 2001
// [DI11]   d'Eon, Irving: A Quantized-Diffusion Model for Rendering Translucent Materials. SIGGRAPH 2011
// [DE12]   d'Eon: A Better Dipole. 2012
#pragma once

#include "tissue/optics/media.h"
#include "tissue/profile/grosjean.h"
#include "tissue/profile/radial.h"

namespace dermis::profile {

/// The classical dipole, [JMLH01] eq. 4: all light begins to diffuse at a depth of one mean free path.
class Dipole final : public RadialProfile {
 public:
  /// Takes a medium that passes optics::check. Without absorption the total is exactly 1 and the tail falls
  /// like 1/r^3.
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
  double z_real_mm_;     // depth of the source below the surface
  double z_virtual_mm_;  // height of its image above the surface
};

/// The better dipole, [DE12]: Grosjean's diffusion coefficient, and exitance from fluence and flux. Holds
/// light scattered more than once only; tissue/profile/beam.h has light scattered once.
class BetterDipole final : public RadialProfile {
 public:
  /// Takes a medium that passes optics::check.
  explicit BetterDipole(const optics::Medium& medium);

  double at(double radius_mm) const override;
  double hankel(double k_per_mm) const override;
  double inner_mm() const override { return z_real_mm_; }
  double outer_mm() const override;
  bool hankel_is_exact() const override { return true; }
  std::string name() const override { return "better dipole"; }

 private:
  GrosjeanDiffusion diffusion_;
  double z_real_mm_;  // depth and height, as above
  double z_virtual_mm_;
};

}  // namespace dermis::profile
