// SPDX-License-Identifier: MIT
// From coefficients to three profiles, by the model that was asked for or the one that fits.
#pragma once

#include <array>
#include <string>
#include <string_view>
#include <vector>

#include "optics/layers.h"
#include "optics/media.h"
#include "profile/monte_carlo.h"
#include "profile/radial.h"

namespace dermis::profile {

enum class Model { dipole, better, multipole, beam, monte_carlo, automatic };

/// "dipole", "better", "multipole", "beam", "monte-carlo", "auto"; InputError lists them.
Model parse_model(std::string_view name);
/// The name that parse_model() takes for it.
std::string_view model_name(Model model);
/// All of them, "auto" last.
std::vector<std::string_view> model_names();

/// Under this reduced albedo diffusion totals are more than a few per cent off: the dipole's by 4 % at 0.95,
/// 10 % at 0.9, 37 % at 0.5 (docs/theory.md has the table), and near the source it is off by far more.
inline constexpr double diffusion_albedo = 0.95;

/// Layers thinner than this many reduced mean free paths are beyond diffusion, too.
inline constexpr double diffusion_thickness = 2;

/// Three profiles, and what made them.
struct ModelledProfiles {
  std::array<ProfilePtr, 3> profiles;
  Model model = Model::dipole;  ///< never automatic
  std::string reason;           ///< why automatic chose it; empty if it was asked for
};

/// A homogeneous half-space. automatic: the dipole where the reduced albedo of all three channels is at least
/// diffusion_albedo, else Monte-Carlo. InputError: values out of range.
ModelledProfiles make_profiles(const optics::RgbMedium& medium, Model model, const MonteCarloOptions& options,
                               const std::string& where);

/// A stack. automatic: the multipole where every layer and channel has that albedo and that thickness, else
/// Monte-Carlo. InputError: dipole, better and beam know no layers.
ModelledProfiles make_profiles(const optics::RgbLayers& layers, Model model, const MonteCarloOptions& options,
                               const std::string& where);

}  // namespace dermis::profile
