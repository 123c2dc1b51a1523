// SPDX-License-Identifier: MIT
/// Skin as a sum of Gaussians, computed from what skin is: the left half of dermis, without a device. `dermis
/// profile` is made of this.
///
///   dermis::ScatterProfile p = dermis::profile_of_skin({.melanin = 0.02, .haemoglobin = 0.01});
///   dermis::write_profile(p, "skin.json");                 // render --profile skin.json
///
/// Everything throws dermis::InputError for values out of range, and Cancelled if a hook ends the work.
/// Nothing depends on the number of threads; equal input gives equal bits.
#pragma once

#include <array>
#include <cstdint>
#include <string>
#include <vector>

#include "dermis/error.h"
#include "dermis/hooks.h"

namespace dermis {

/// R(r) = total * sum_i w_i exp(-r^2 / (2 v_i)) / (2 pi v_i), r in mm, per colour channel (linear Rec.709).
struct ScatterProfile {
  std::string name;
  std::string model;                           ///< which model made it
  std::vector<double> variances_mm2;           ///< 1 to 8, rising
  std::vector<std::array<double, 3>> weights;  ///< as many, >= 0, summing to 1 per channel
  std::array<double, 3> error_percent{};       ///< of the fit, docs/theory.md
  std::array<double, 3> total_reflectance{};   ///< 0..1: model_total, cut to 1
  /// 1 / sigma_t'; of the equivalent half-space where skin has layers
  std::array<double, 3> mean_free_path_mm{};
  std::array<double, 3> diffuse_mean_free_path_mm{};  ///< 1 / sigma_tr; 0 where there is no absorption
  std::array<double, 3>
      model_total{};  ///< what the model itself reflects; "beam" can give more light back than entered
};

/// A homogeneous half-space per channel.
struct Coefficients {
  std::array<double, 3> sigma_a_per_mm{};  ///< 0 to 1e6
  std::array<double, 3> sigma_s_per_mm{};  ///< 0 to 1e6
  double g = 0;                            ///< above -1, below 1
  double eta = 1.4;                        ///< 1 to 3
};

/// Spectral skin (Donner and Jensen 2006).
struct SpectralSkin {
  double melanin = 0.02;       ///< volume fraction in the epidermis, 0 to 0.5
  double blend = 0.7;          ///< eumelanin's share, 0 to 1
  double haemoglobin = 0.01;   ///< volume fraction of blood in the dermis, 0 to 0.1
  double oxygenation = 0.75;   ///< 0 to 1
  double epidermis_mm = 0.25;  ///< 0.01 to 2
};

/// How light is taken to spread; docs/theory.md has the equations, and how far each is from the truth.
enum class ProfileModel : std::uint8_t {
  dipole,       ///< of a half-space [JMLH01]
  better,       ///< the better dipole; leaves out light that scattered only once
  multipole,    ///< of layers
  beam,         ///< photon beam diffusion
  monte_carlo,  ///< photons, seconds
  automatic     ///< the cheapest that is right for the coefficients
};

/// How to compute.
struct ProfileOptions {
  int gaussians = 6;  ///< 1 to 8
  ProfileModel model = ProfileModel::automatic;
  std::uint64_t photons = 500'000;  ///< Monte-Carlo, per channel: 1e3 to 1e9; time is proportional
  std::uint64_t seed = 1;
};

/// "skin1", "skin2", "marble", ..., "skin-layers"; an unknown name lists all. 10 ms by the dipole, seconds by
/// Monte-Carlo.
ScatterProfile profile_of_preset(const std::string& name, const ProfileOptions& options = {},
                                 const Hooks& hooks = {});
/// Of a half-space with these coefficients (per mm, ranges above): [JMLH01] and the other models of
/// docs/theory.md; times as above.
ScatterProfile profile_of_coefficients(const Coefficients& coefficients, const ProfileOptions& options = {},
                                       const Hooks& hooks = {});
/// Of spectral skin, R_c(r) = Sum w_c(nm) R(nm, r) over 31 wavelengths under D65 (docs/theory.md); multipole,
/// monte-carlo or auto. Seconds.
ScatterProfile profile_of_skin(const SpectralSkin& skin, const ProfileOptions& options = {},
                               const Hooks& hooks = {});
/// The nearest skin to "#rrggbb" (sRGB) or "L,a,b" (CIELAB); delta_e, if given, receives the distance
/// (CIE76).
SpectralSkin skin_of_colour(const std::string& colour, double* delta_e = nullptr, const Hooks& hooks = {});

/// The profile file that render --profile takes, atomically.
void write_profile(const ScatterProfile& profile, const std::string& path);

}  // namespace dermis
