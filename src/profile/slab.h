// SPDX-License-Identifier: MIT
// Layers: a slab by many dipoles (multipole), and stacks of slabs by adding, both per spatial frequency,
// where all sums close. Based on: [DJ05] Donner, Jensen: Light Diffusion in Multi-Layered Translucent
// Materials. SIGGRAPH 2005
#pragma once

#include <string>

#include "optics/layers.h"
#include "profile/radial.h"

namespace dermis::profile {

/// What a layer (or a stack) does at one spatial frequency; dimensionless, 0..1 at k = 0. Diffuse light and a
/// beam are kept apart because a beam that nothing has turned yet leaves through the far boundary, where
/// diffuse light is mostly reflected back.
struct Spectra {
  double reflect_above = 0;   ///< R+, diffuse light from above
  double transmit_above = 0;  ///< T+, from above to below
  double reflect_below = 0;   ///< R-
  double transmit_below = 0;  ///< T-
  /// A perpendicular beam from above: R+, all of T+, and that part of T+ which is a beam still.
  struct Beam {
    double reflect = 0, transmit = 0, straight = 0;
  } beam;
};

/// Reflectance and transmittance of light from one side.
struct TwoFlux {
  double reflect, transmit;
};
/// The closed sums of Multipole below, over alpha', for light that enters at the side of z_b0; d > l, lengths
/// and 1/kappa in one unit.
TwoFlux multipole_sums(double kappa, double l, double d, double z_b0, double z_bd);

/// One layer between two media of index eta_above and eta_below: the multipole of [DJ05] sec. 3, summed in
/// closed form. With l = 1/sigma_t', z_b = 2 A D at either side, P = 2 (d + z_b0 + z_bd), kappa =
/// sqrt(sigma_tr^2 + k^2):
///   R^ = alpha'/2 [ e^{-l kappa} - e^{-(P-l) kappa} - e^{-(P-l-2 z_b0) kappa} + e^{-(l+2 z_b0) kappa} ] / (1
///   - e^{-P kappa}) T^ = alpha'/2 [ e^{-(d-l) kappa} - e^{-(P+l-d) kappa} - e^{-(d+l+2 z_b0) kappa} +
///   e^{-(d+2 z_bd-l) kappa} ] / (1 - e^{-P kappa}).
/// Departure: diffusion has nothing to say of layers of about one mean free path and less. Under thin_limit()
/// of them R and T come from profile/thin_slab.h instead: a vanishing layer vanishes, energy is kept, and two
/// such halves are the whole within 0.04 (indices up to 1.6; measured in docs/theory.md).
class Multipole {
 public:
  /// layer as optics::check wants it; an infinite thickness makes it the dipole, which transmits nothing.
  Multipole(const optics::Layer& layer, double eta_above, double eta_below);

  /// All of it, k >= 0 in 1/mm.
  Spectra spectra(double k_per_mm) const;
  /// Thinner than diffusion can tell: the beam differs from diffuse light, and the images below do not hold.
  bool thin() const { return thin_; }
  /// About the length [mm] over which the narrowest of R and T changes; the reach of the widest.
  double inner_mm() const;
  double outer_mm() const;

  /// R(r) and T(r) for a beam from above [1/mm^2], summed image by image until terms fall under 1e-7 of the
  /// sum; not for thin() slabs.
  double reflectance_at(double radius_mm) const;
  double transmittance_at(double radius_mm) const;

 private:
  double image_sum(double radius_mm, bool transmitted) const;
  Spectra closed_sums(double k_per_mm, double thickness_mm) const;

  double reduced_albedo_;
  double sigma_tr_per_mm_;
  double source_mm_;     // l, depth of the source
  double thickness_mm_;  // d
  double above_mm_;      // z_b(0)
  double below_mm_;      // z_b(d)
  bool thin_ = false;
};

/// Light that leaves a slab, above or below, as a profile.
class SlabProfile final : public RadialProfile {
 public:
  enum class Side { reflected, transmitted };
  /// layer with a thickness > 0 mm that may be infinite; eta_above and eta_below are the indices of what lies
  /// on its two sides, relative to air as the layer's own, 1 to 3 (1: air).
  SlabProfile(const optics::Layer& layer, Side side, double eta_above = 1, double eta_below = 1);

  double at(double radius_mm) const override;
  double hankel(double k_per_mm) const override;
  double inner_mm() const override { return slab_.inner_mm(); }
  double outer_mm() const override { return slab_.outer_mm(); }
  bool hankel_is_exact() const override { return true; }
  std::string name() const override {
    return side_ == Side::reflected ? "multipole" : "multipole, transmitted";
  }

 private:
  Multipole slab_;
  Side side_;
};

/// Light of a beam that leaves a stack. [DJ05] sec. 4, per frequency, folded from the bottom, see add(). An
/// index step between layers enters through A only.
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

  /// Both sides of the whole stack.
  Spectra spectra(double k_per_mm) const;

 private:
  std::vector<Multipole> slabs_;
  Side side_;
  double inner_mm_, outer_mm_;
};

/// Two layers, `upper` above `lower`, as one. [DJ05] eq. 15 to 17:
///   R12+ = R1+ + T1+ R2+ T1- / (1 - R2+ R1-),  T12+ = T1+ T2+ / (1 - R2+ R1-), and the same from below.
/// A beam b reaches the lower layer as s1 of beam and t1 - s1 of diffuse light, and y = (s1 r2 + R2+ (t1 -
/// s1)) / (1 - R2+ R1-) comes up:
///   r12 = r1 + T1- y,  t12 = s1 t2 + T2+ (t1 - s1 + R1- y),  s12 = s1 s2.
Spectra add(const Spectra& upper, const Spectra& lower);

}  // namespace dermis::profile
