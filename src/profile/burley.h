// SPDX-License-Identifier: MIT
// Normalised diffusion: a curve fitted to Monte-Carlo by others, which several engines use.
// Based on: [CB15] Christensen, Burley: Approximate Reflectance Profiles for Efficient Subsurface Scattering.
// Pixar TM 15-04, 2015
#pragma once

#include <string>

#include "optics/media.h"
#include "profile/radial.h"

namespace dermis::profile {

/// R(r) = A (e^{-r/d} + e^{-r/(3d)}) / (8 pi d r), total A exactly, R^(k) = A/4 [ 1/sqrt(1+(kd)^2) +
/// 3/sqrt(1+(3kd)^2) ].
class Burley final : public RadialProfile {
 public:
  /// A 0..1, shape d > 0 in mm (InputError otherwise, place `where`). Engines call d the scattering distance
  /// (Unity) or compute it from a length.
  Burley(double total_reflectance, double shape_mm, const std::string& where);
  /// Mean free path, light that enters perpendicularly: d = l/s, s = 1.85 - A + 7 |A - 0.8|^3. [CB15] eq. 5,
  /// its error 5.5 %.
  static double shape_mm(double total_reflectance, optics::MeanFreePath length);
  /// Diffuse mean free path: s = 3.5 + 100 (A - 0.33)^4. [CB15] eq. 8, its error 7.7 %.
  static double shape_mm(double total_reflectance, optics::DiffuseMeanFreePath length);
  /// Mean free path, light that enters from everywhere: s = 1.9 - A + 3.5 (A - 0.8)^2. [CB15] eq. 6, its
  /// error 3.9 %.
  static double shape_all_angles_mm(double total_reflectance, optics::MeanFreePath length);

  double at(double radius_mm) const override;
  double hankel(double k_per_mm) const override;
  double total() const override { return total_; }
  /// A (1 - e^{-r/d}/4 - 3 e^{-r/(3d)}/4).
  double within(double radius_mm) const override;
  /// Inverse of within(): with u = 1 - p, G = 1 + 4u (2u + sqrt(1 + 4u^2)), r = 3 d ln( (1 + G^{-1/3} +
  /// G^{1/3}) / (4u) ).
  double quantile(double p) const override;
  /// T(t) = A/4 (e^{-t/d} + 3 e^{-t/(3d)}): what passes a slab of thickness t [mm] >= 0.
  double slab_transmittance(double thickness_mm) const;
  double inner_mm() const override { return shape_mm_; }
  double outer_mm() const override { return 3 * shape_mm_; }
  bool has_pole() const override { return true; }
  std::string name() const override { return "Burley"; }

 private:
  double total_, shape_mm_;
};

/// Three Burley profiles as text gives them.
struct BurleyDescription {
  optics::Rgb total_reflectance{}, shape_mm{};
};

/// "reflectance=R,G,B" and one of "mfp_mm=", "dmfp_mm=", "shape_mm=", each one number or three. InputError:
/// as optics::parse_key_values, none or several lengths (a bare "radius" has three readings, which is why it
/// is none of the keys), out of range.
BurleyDescription parse_burley(const std::string& text, const std::string& where);

}  // namespace dermis::profile
