// SPDX-License-Identifier: MIT
// Layers: a slab as a sum of many dipoles (multipole), and stacks of slabs by adding. Both work per spatial
// frequency, where all sums have a closed form.
// Based on:
// [DJ05] Donner, Jensen: Light Diffusion in Multi-Layered Translucent Materials. SIGGRAPH 2005
#pragma once

#include <string>

#include "tissue/optics/layers.h"
#include "tissue/profile/radial.h"

namespace dermis::profile {

/// Reflectance and transmittance of a layer or a stack at one spatial frequency k; dimensionless, 0..1 where
/// k is 0. Diffuse light and a beam are kept apart: an unscattered beam leaves through the far boundary,
/// where diffuse light is mostly reflected back.
struct Spectra {
  double reflect_above = 0;   ///< R+, diffuse light from above
  double transmit_above = 0;  ///< T+, from above to below
  double reflect_below = 0;   ///< R-
  double transmit_below = 0;  ///< T-
  /// For a perpendicular beam from above: R+, all of T+, and the part of T+ that is still unscattered.
  struct Beam {
    double reflect = 0, transmit = 0, straight = 0;
  } beam;
};

/// Reflectance and transmittance of light from one side.
struct TwoFlux {
  double reflect, transmit;
};
/// Returns R^ / alpha' and T^ / alpha' of a slab of thickness d with its source at depth l < d. z_b0 and z_bd
/// are the extrapolation lengths where light enters and on the far side; kappa = sqrt(sigma_tr^2 + k^2).
/// Lengths and 1/kappa in one unit.
TwoFlux multipole_sums(double kappa, double l, double d, double z_b0, double z_bd);

/// One layer between two media of index eta_above and eta_below: the multipole of [DJ05] sec. 3, summed in
/// closed form.
///
/// Departs from [DJ05]: diffusion fails for layers of about one mean free path and less, so below
/// thin_limit() mean free paths R and T come from tissue/profile/thin_slab.h. There the effect of a layer
/// goes to 0 with its thickness, and energy is kept. Two half-slabs added reproduce the full slab within 0.04
/// (indices up to 1.6; measured in docs/theory.md).
class Multipole {
 public:
  /// Takes a layer that passes optics::check. An infinite thickness makes it the dipole, which transmits
  /// nothing.
  Multipole(const optics::Layer& layer, double eta_above, double eta_below);

  /// Returns reflectance and transmittance from both sides, k >= 0 in 1/mm.
  Spectra spectra(double k_per_mm) const;
  /// True if the slab is too thin for diffusion: the beam differs from diffuse light, and the image sums
  /// below do not hold.
  bool thin() const { return thin_; }
  /// Return about the length [mm] over which the narrowest of R and T changes, and the reach of the widest.
  double inner_mm() const;
  double outer_mm() const;

  /// Return R(r) and T(r) for a beam from above [1/mm^2], summed image by image until terms fall below 1e-9
  /// of the sum; not for thin() slabs.
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

/// The light that leaves a slab, above or below, as a profile.
class SlabProfile final : public RadialProfile {
 public:
  enum class Side { reflected, transmitted };
  /// Takes a layer of thickness > 0 mm, which may be infinite. eta_above and eta_below are the indices on its
  /// two sides, relative to air (as is the layer's own), 1 to 3.
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

/// The light of a beam that leaves a stack: slabs added per frequency from the bottom, see add(). [DJ05]
/// sec. 4. An index step between layers enters through A only.
class LayeredProfile final : public RadialProfile {
 public:
  using Side = SlabProfile::Side;
  /// Takes layers with air above and below; throws InputError (place `where`) if optics::check rejects them.
  LayeredProfile(const optics::Layers& layers, Side side, const std::string& where = "layers");

  double at(double radius_mm) const override { return inverse_hankel(*this, radius_mm); }
  double hankel(double k_per_mm) const override;
  double inner_mm() const override { return inner_mm_; }
  double outer_mm() const override { return outer_mm_; }
  bool hankel_is_exact() const override { return true; }
  std::string name() const override;

  /// Returns reflectance and transmittance of the whole stack from both sides.
  Spectra spectra(double k_per_mm) const;

 private:
  std::vector<Multipole> slabs_;
  Side side_;
  double inner_mm_, outer_mm_;
};

/// Returns two layers, `upper` above `lower`, as one. [DJ05] eq. 15 to 17, and the same for a beam.
Spectra add(const Spectra& upper, const Spectra& lower);

}  // namespace dermis::profile
