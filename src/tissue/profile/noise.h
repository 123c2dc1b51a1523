// SPDX-License-Identifier: MIT
// Noise of a profile that was made by sampling.
#pragma once

#include <optional>

#include "tissue/profile/radial.h"

namespace dermis::profile {

/// The errors of a sampled profile.
struct Sampled {
  /// 100 sqrt( Int r error^2 dr / Int r R^2 dr ), from the radius that holds 5 % of the light
  double noise_percent = 0;
  /// fraction 0..1 of the entered light whose photons were ended before it left or was absorbed
  double cut = 0;
};

/// Returns the errors of a Monte-Carlo profile, or of spectral skin made of such profiles; nothing for all
/// other models.
std::optional<Sampled> sampled(const RadialProfile& profile);

}  // namespace dermis::profile
