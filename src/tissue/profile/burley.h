// SPDX-License-Identifier: MIT
// Normalised diffusion: a curve fitted to Monte-Carlo results, which several engines use.
// Based on:
// [CB15] Christensen, Burley: Approximate Reflectance Profiles for Efficient Subsurface Scattering.
//        Pixar TM 15-04, 2015
#pragma once

#include <string>

#include "tissue/optics/media.h"
#include "tissue/profile/radial.h"

namespace dermis::profile {

/// R(r) = A (e^{-r/d} + e^{-r/(3d)}) / (8 pi d r), whose total is exactly A.
class Burley final : public RadialProfile {
 public:
  /// Takes A in 0..1 and the shape d > 0 in mm; throws InputError (place `where`) otherwise. Unity calls d
  /// the scattering distance; other engines compute it from a length.
  Burley(double total_reflectance, double shape_mm, const std::string& where);
  /// Returns d for a mean free path and light that enters perpendicularly. [CB15] eq. 5, whose error is 5.5
  /// %.
  static double shape_mm(double total_reflectance, optics::MeanFreePath length);
  /// Returns d for a diffuse mean free path. [CB15] eq. 8, whose error is 7.7 %.
  static double shape_mm(double total_reflectance, optics::DiffuseMeanFreePath length);
  /// Returns d for a mean free path and diffuse incident light. [CB15] eq. 6, whose error is 3.9 %.
  static double shape_all_angles_mm(double total_reflectance, optics::MeanFreePath length);

  double at(double radius_mm) const override;
  double hankel(double k_per_mm) const override;
  double total() const override { return total_; }
  /// A (1 - e^{-r/d}/4 - 3 e^{-r/(3d)}/4).
  double within(double radius_mm) const override;
  /// Inverse of within(), in closed form.
  double quantile(double p) const override;
  double inner_mm() const override { return shape_mm_; }
  double outer_mm() const override { return 3 * shape_mm_; }
  bool has_pole() const override { return true; }
  std::string name() const override { return "Burley"; }

 private:
  double total_, shape_mm_;
};

/// A Burley profile per colour channel, as text gives them.
struct BurleyDescription {
  optics::Rgb total_reflectance{}, shape_mm{};
};

/// Parses "reflectance=R,G,B" and one of "mfp_mm=", "dmfp_mm=", "shape_mm=", each one number or three. There
/// is no key "radius", because engines mean three different lengths by it. Throws InputError: as
/// optics::parse_key_values does; no length or several; a value out of range.
BurleyDescription parse_burley(const std::string& text, const std::string& where);

}  // namespace dermis::profile
