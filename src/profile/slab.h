// SPDX-License-Identifier: MIT
// Layers: a slab by many dipoles (multipole), and stacks of slabs by adding, both per spatial frequency, where all sums close.
// Based on: [DJ05] Donner, Jensen: Light Diffusion in Multi-Layered Translucent Materials. SIGGRAPH 2005
#pragma once

#include <string>

#include "optics/layers.h"
#include "profile/radial.h"

namespace dermis::profile {

/// What a layer (or a stack) does at one spatial frequency; dimensionless, 0..1 at k = 0.
struct Spectra {
  double reflect_above = 0;   ///< R+, lit from above
  double transmit_above = 0;  ///< T+, from above to below
  double reflect_below = 0;   ///< R-
  double transmit_below = 0;  ///< T-
};

/// One layer between two media of index eta_above and eta_below: the multipole of [DJ05] sec. 3, summed in closed form. With l =
/// 1/sigma_t', z_b = 2 A D at either side, P = 2 (d + z_b0 + z_bd), kappa = sqrt(sigma_tr^2 + k^2):
///   R^ = alpha'/2 [ e^{-l kappa} - e^{-(P-l) kappa} - e^{-(P-l-2 z_b0) kappa} + e^{-(l+2 z_b0) kappa} ] / (1 - e^{-P kappa})
///   T^ = alpha'/2 [ e^{-(d-l) kappa} - e^{-(P+l-d) kappa} - e^{-(d+l+2 z_b0) kappa} + e^{-(d+2 z_bd-l) kappa} ] / (1 - e^{-P kappa}).
/// Departure: diffusion has nothing to say of layers of about one mean free path and less. Under 1.1 of them the source moves from depth l
/// towards d/2 as the layer thins, R and T are scaled by f = (1 - e^{-d/l})/(1 - e^{-1.1}), and 1 - f passes straight: continuous, a
/// vanishing layer vanishes, and energy is kept. Two such halves differ from the whole by up to 0.11 in T (measured; 0.04 from 1.5 mean
/// free paths on).
class Multipole {
 public:
  /// layer as optics::check wants it; an infinite thickness makes it the dipole, which transmits nothing.
  Multipole(const optics::Layer& layer, double eta_above, double eta_below);

  /// All four, k >= 0 in 1/mm; the part that passes straight is included.
  Spectra spectra(double k_per_mm) const;
  /// 1 - f, the part of the transmitted light that leaves where it entered: a delta at r = 0.
  double straight() const { return straight_; }
  double inner_mm() const { return source_mm_; }
  double outer_mm() const;

  /// R(r) and T(r) for light from above [1/mm^2], summed image by image until terms fall under 1e-7 of the sum; without the straight part.
  double reflectance_at(double radius_mm) const;
  double transmittance_at(double radius_mm) const;

 private:
  double image_sum(double radius_mm, bool transmitted) const;

  double reduced_albedo_;
  double sigma_tr_per_mm_;
  double source_mm_;     // l, depth of the source
  double thickness_mm_;  // d
  double above_mm_;      // z_b(0)
  double below_mm_;      // z_b(d)
  double scale_ = 1;     // f
  double straight_ = 0;
};

/// Light that leaves a slab, above or below, as a profile.
class SlabProfile final : public RadialProfile {
 public:
  enum class Side { reflected, transmitted };
  SlabProfile(const optics::Layer& layer, Side side, double eta_above = 1, double eta_below = 1);

  double at(double radius_mm) const override;
  double hankel(double k_per_mm) const override;
  double inner_mm() const override { return slab_.inner_mm(); }
  double outer_mm() const override { return slab_.outer_mm(); }
  bool hankel_is_exact() const override { return true; }
  std::string name() const override { return side_ == Side::reflected ? "multipole" : "multipole, transmitted"; }

 private:
  Multipole slab_;
  Side side_;
};

/// Light that leaves a stack. [DJ05] sec. 4, per frequency, folded from the bottom:
///   R12+ = R1+ + T1+ R2+ T1- / (1 - R2+ R1-),  T12+ = T1+ T2+ / (1 - R2+ R1-), and the same from below.
/// An index step between layers enters through A only. The part that passes all layers straight is left out of at() and hankel().
class LayeredProfile final : public RadialProfile {
 public:
  using Side = SlabProfile::Side;
  /// layers as optics::check wants them (InputError through it, place `where`), air above and below.
  LayeredProfile(const optics::Layers& layers, Side side, const std::string& where = "layers");

  double at(double radius_mm) const override { return inverse_hankel(*this, radius_mm); }
  double hankel(double k_per_mm) const override;
  double inner_mm() const override { return inner_mm_; }
  double outer_mm() const override { return outer_mm_; }
  bool hankel_is_exact() const override { return true; }
  std::string name() const override;

  /// Both sides of the whole stack, straight part included.
  Spectra spectra(double k_per_mm) const;
  double straight() const { return straight_; }

 private:
  std::vector<Multipole> slabs_;
  Side side_;
  double straight_ = 1;
  double inner_mm_, outer_mm_;
};

/// Two layers, `upper` above `lower`, as one. [DJ05] eq. 15 to 17.
Spectra add(const Spectra& upper, const Spectra& lower);

}  // namespace dermis::profile
