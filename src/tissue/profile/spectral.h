// SPDX-License-Identifier: MIT
// Spectral skin as three profiles, one per colour channel, whose totals are its colour.
// Based on: [DJ06] Donner, Jensen: A Spectral BSSRDF for Shading Human Skin. EGSR 2006
#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "tissue/optics/skin.h"
#include "tissue/profile/model.h"

namespace dermis::profile {

/// Number of wavelengths, 400 to 700 nm, at which profiles are computed.
inline constexpr std::size_t spectral_samples = 31;

/// Sum_i w_i R_i(r): one colour channel of profiles of single wavelengths. Weights may be negative (the
/// Rec.709 primaries do not span all spectral colours), so R may fall below 0 near the source although its
/// total does not.
class WeightedProfile final : public RadialProfile {
 public:
  struct Part {
    double weight;
    ProfilePtr profile;
  };
  /// Scales the weights so that the total is `total`. Throws InputError (place `where`) if it is not > 0: the
  /// colour is outside Rec.709.
  WeightedProfile(std::vector<Part> parts, double total, std::string name, const std::string& where);

  double at(double radius_mm) const override;
  /// The errors of the parts are independent.
  double standard_error_at(double radius_mm) const override;
  double hankel(double k_per_mm) const override;
  double within(double radius_mm) const override;
  /// Finds the radius by bisection on within().
  double quantile(double p) const override;
  double inner_mm() const override { return inner_mm_; }
  double outer_mm() const override { return outer_mm_; }
  bool hankel_is_exact() const override { return exact_; }
  bool has_pole() const override { return pole_; }
  std::string name() const override { return name_; }
  /// Returns the parts, with scaled weights.
  const std::vector<Part>& parts() const { return parts_; }

 private:
  std::vector<Part> parts_;
  std::string name_;
  double inner_mm_ = 1e300, outer_mm_ = 0;
  bool exact_ = true, pole_ = false;
};

/// Makes the three profiles. A reflectance spectrum becomes a colour by a weighted sum over wavelengths
/// (optics::rec709_weights), and the same weights hold at each distance: R_c(r) = Sum_i w_c(nm_i) R(nm_i, r).
/// So the integral of each channel's profile *is* that channel of the colour, and no single wavelength stands
/// for "red". R(nm, r) is computed every 10 nm from 400 to 700 nm and interpolated between. Each channel is
/// then scaled (by a few per cent at most) to the exact total of 81 wavelengths.
///
/// Models: multipole, monte-carlo, automatic. Automatic takes Monte-Carlo if at some wavelength a layer has a
/// reduced albedo below diffusion_albedo or the epidermis is thinner than diffusion_thickness. That holds for
/// all skin but the palest and thickest. Monte-Carlo shares photons among wavelengths: options.photons / 16
/// each.
ModelledProfiles make_profiles(const SpectralSkin& skin, Model model, const MonteCarloOptions& options,
                               const std::string& where);

}  // namespace dermis::profile
