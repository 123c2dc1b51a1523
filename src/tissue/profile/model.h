// SPDX-License-Identifier: MIT
// Makes three profiles from coefficients, by the model asked for or by the one that fits.
#pragma once

#include <array>
#include <string>

#include "dermis/profile.h"
#include "tissue/optics/layers.h"
#include "tissue/optics/media.h"
#include "tissue/profile/monte_carlo.h"
#include "tissue/profile/radial.h"

namespace dermis::profile {

using Model = ProfileModel;

/// Below this reduced albedo the totals of diffusion are more than a few per cent off: the dipole's by 4 % at
/// 0.95, 10 % at 0.9, 37 % at 0.5 (table in docs/theory.md). Near the source the error is far larger.
inline constexpr double diffusion_albedo = 0.95;

/// Diffusion also fails for layers thinner than this many reduced mean free paths.
inline constexpr double diffusion_thickness = 2;

/// Three profiles and the model that made them.
struct ModelledProfiles {
  std::array<ProfilePtr, 3> profiles;
  Model model = Model::dipole;  ///< never automatic
  std::string reason;           ///< why automatic chose it; empty if it was asked for
};

/// Makes the profiles of a homogeneous half-space. Model::automatic takes the dipole if the reduced albedo of
/// all three channels is at least diffusion_albedo, else Monte-Carlo. Throws InputError for values out of
/// range.
ModelledProfiles make_profiles(const optics::RgbMedium& medium, Model model, const MonteCarloOptions& options,
                               const std::string& where);

/// Makes the profiles of a stack. Model::automatic takes the multipole if every layer and channel reaches
/// diffusion_albedo and diffusion_thickness, else Monte-Carlo. Throws InputError for dipole, better and beam,
/// which have no layers.
ModelledProfiles make_profiles(const optics::RgbLayers& layers, Model model, const MonteCarloOptions& options,
                               const std::string& where);

}  // namespace dermis::profile
