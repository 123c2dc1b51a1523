// SPDX-License-Identifier: MIT
// How far a profile that was sampled can be trusted.
#pragma once

#include <optional>

#include "profile/radial.h"

namespace dermis::profile {

/// What chance and the end of patience have done to a profile.
struct Sampled {
  /// 100 sqrt( Int r error^2 dr / Int r R^2 dr ), from the radius of 5 % of the light on
  double noise_percent = 0;
  /// part of the light that entered and was still on its way when its photons were given up, 0..1
  double cut = 0;
};

/// Of Monte-Carlo, and of spectral skin made of it: there errors of the wavelengths are independent, so their
/// squares add up with the squares of the weights. Nothing for every other model.
std::optional<Sampled> sampled(const RadialProfile& profile);

}  // namespace dermis::profile
