// SPDX-License-Identifier: MIT
// Spectral skin as three profiles that are right for its colour.
// Based on: [DJ06] Donner, Jensen: A Spectral BSSRDF for Shading Human Skin. EGSR 2006
#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "optics/skin.h"
#include "profile/model.h"

namespace dermis::profile {

/// At how many wavelengths the profile of spectral skin is computed, 400 to 700 nm.
inline constexpr std::size_t spectral_samples = 31;

/// Sum_i w_i R_i(r): profiles of single wavelengths as one colour channel sees them. Weights may be negative
/// (the Rec.709 primaries do not span the spectrum's colours), so R may dip below 0 near the source although
/// its total does not.
class WeightedProfile final : public RadialProfile {
 public:
  struct Part {
    double weight;
    ProfilePtr profile;
  };
  /// scaled so that the total is `total` (> 0, else InputError with `where` as the place: the colour is
  /// outside Rec.709).
  WeightedProfile(std::vector<Part> parts, double total, std::string name, const std::string& where);

  double at(double radius_mm) const override;
  double hankel(double k_per_mm) const override;
  double within(double radius_mm) const override;
  /// By bisection on within().
  double quantile(double p) const override;
  double inner_mm() const override { return inner_mm_; }
  double outer_mm() const override { return outer_mm_; }
  bool hankel_is_exact() const override { return exact_; }
  bool has_pole() const override { return pole_; }
  std::string name() const override { return name_; }
  /// What it is made of, the weights scaled to the total.
  const std::vector<Part>& parts() const { return parts_; }

 private:
  std::vector<Part> parts_;
  std::string name_;
  double inner_mm_ = 1e300, outer_mm_ = 0;
  bool exact_ = true, pole_ = false;
};

/// Integrating the light that skin sends back over the spectrum is linear, at every distance as in total:
/// R_c(r) = Sum_i w_c(nm_i) R(nm_i, r) with the very weights that make a reflectance spectrum a colour
/// (optics::rec709_weights). So the integral of each channel's profile *is* that channel of the colour, and
/// no single wavelength has to stand for "red". R(nm, r) is computed every 10 nm from 400 to 700 nm and
/// interpolated in between; each channel is then scaled (by a few per cent at most) to the exact total of 81
/// wavelengths. Models: multipole, monte-carlo, automatic (Monte-Carlo where at some wavelength a layer has a
/// reduced albedo under diffusion_albedo or the epidermis is thinner than diffusion_thickness, which is all
/// skin but the palest and thickest). Monte-Carlo shares photons among wavelengths: 1/16 of options.photons
/// each.
ModelledProfiles make_profiles(const optics::Skin& skin, Model model, const MonteCarloOptions& options,
                               const std::string& where);

}  // namespace dermis::profile
