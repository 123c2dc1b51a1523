// SPDX-License-Identifier: MIT
/// Skin as a sum of Gaussians, computed from what skin is: the left half of dermis, without a device. `dermis
/// profile` is made of this.
///
///   dermis::ScatterProfile p = dermis::profile_of_skin({.melanin = 0.02, .haemoglobin = 0.01});
///   dermis::write_profile(p, "skin.json");                 // render --profile skin.json
///   dermis::ProfileTable model = dermis::model_table(p);   // R(r) and its noise; reflectance(p, r): the fit
///
/// Everything throws dermis::InputError for values out of range, and Cancelled if a hook ends the work.
/// Nothing depends on the number of threads; equal input gives equal bits.
#pragma once

#include <array>
#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "dermis/error.h"
#include "dermis/hooks.h"

namespace dermis {

/// R(r) of each colour channel as the model computed it, before the fit; opaque, for model_table().
struct ModelCurves;

/// R(r) of each colour channel at some radii.
struct ProfileTable {
  std::vector<double> r_mm;  ///< rising, evenly in log r; at most 1e-3 of the light leaves nearer or further
  std::vector<std::array<double, 3>> reflectance_per_mm2;  ///< as many
  /// As many: the noise of Monte-Carlo, one standard deviation; it shrinks as 1 / sqrt(photons). 0 of other
  /// models.
  std::vector<std::array<double, 3>> standard_error_per_mm2;
};

/// A homogeneous half-space per channel.
struct Coefficients {
  std::array<double, 3> sigma_a_per_mm{};  ///< 0 to 1e6
  std::array<double, 3> sigma_s_per_mm{};  ///< 0 to 1e6
  double g = 0;                            ///< above -1, below 1
  double eta = 1.4;                        ///< 1 to 3
  bool operator==(const Coefficients&) const = default;
};

/// Share of the light that leaves curved and thin skin, relative to a flat half-space. The laws are fitted to
/// light followed through spheres, cylinders and slabs (docs/theory.md, "Shapes"). Per channel.
struct ShapeLaws {
  // Total over curvature: 1 + a H / (1 + b |H| + e D) + c D^2, H the mean of the principal curvatures (1/mm,
  // convex positive) and D half of their difference.
  std::array<double, 3> curvature_mm{};    ///< a
  std::array<double, 3> convex_mm{};       ///< b where H > 0; may be negative
  std::array<double, 3> concave_mm{};      ///< b where H < 0
  std::array<double, 3> difference_mm{};   ///< e; may be negative
  std::array<double, 3> difference_mm2{};  ///< c
  // Front of a slab over its thickness d: 1 - share exp(-d / front_mm). Its back: slab_back().
  std::array<double, 3> front_share{};  ///< 0..1
  std::array<double, 3> front_mm{};     ///< > 0
  // Radiance over exitance / pi, over the cosine x of the angle of exit: grazing + (normal - grazing) x^2.
  std::array<double, 3> exit_grazing{1, 1, 1}, exit_normal{1, 1, 1};
  /// >= 0: what leaves at an angle t from the normal is the light of a place this times sin t further away
  /// from the eye
  std::array<double, 3> exit_offset_mm{};
  bool operator==(const ShapeLaws&) const = default;
};

/// One term of a profile.
struct Gaussian {
  double variance_mm2 = 0;         ///< > 0
  std::array<double, 3> weight{};  ///< >= 0
  bool operator==(const Gaussian&) const = default;
};

/// R(r) = total * sum_i w_i exp(-r^2 / (2 v_i)) / (2 pi v_i), r in mm, per colour channel (linear Rec.709).
struct ScatterProfile {
  std::string name;
  std::string model;  ///< the model that made it ("dipole", "Monte-Carlo", ...); empty: published or unknown
  std::vector<Gaussian> terms;  ///< 1 to 8, narrow to wide; weights sum to 1 per channel within 1e-3
  /// 0..1: model_total, cut to 1; the integral of R over the plane
  std::array<double, 3> total_reflectance{1, 1, 1};
  /// 100 sqrt(Int r (R - S)^2 dr / Int r R^2 dr) of the fit S; 0: published or unknown
  std::array<double, 3> error_percent{};
  /// 1 / sigma_t'; of the equivalent half-space where skin has layers; 0: unknown
  std::array<double, 3> mean_free_path_mm{};
  std::array<double, 3> diffuse_mean_free_path_mm{};  ///< 1 / sigma_tr; 0 where there is no absorption
  /// The medium of the profile, index included, in which ground truth follows light. Of layers and spectral
  /// skin, the equivalent half-space. None of published sets, and of files before there was one.
  std::optional<Coefficients> medium;
  /// change of its light with the shape of the body; with a medium alone
  std::optional<ShapeLaws> shape;

  // Added by profile_of_...(), and kept by no file.
  /// reflectance of the model itself; "beam" can give more light back than entered
  std::array<double, 3> model_total{};
  std::string model_reason;  ///< why ProfileModel::automatic chose the model; empty if it was asked for
  /// null of a profile that profile_of_...() has not made; shared by copies
  std::shared_ptr<const ModelCurves> model_curves;
  /// Of Monte-Carlo, as the fit sees it: 100 sqrt(Int r error^2 dr / Int r R^2 dr). 0 of other models.
  std::array<double, 3> noise_percent{};
  /// 0..1, of the light: photons that were given up after 200,000 scatterings
  std::array<double, 3> missing_light{};

  double max_variance_mm2() const { return terms.empty() ? 0 : terms.back().variance_mm2; }
  bool operator==(const ScatterProfile&) const = default;
};

/// Spectral skin (Donner and Jensen 2006).
struct SpectralSkin {
  double melanin = 0.02;       ///< volume fraction in the epidermis, 0 to 0.5
  double blend = 0.7;          ///< eumelanin's share, 0 to 1
  double haemoglobin = 0.01;   ///< volume fraction of blood in the dermis, 0 to 0.1
  double oxygenation = 0.75;   ///< 0 to 1
  double epidermis_mm = 0.25;  ///< 0.01 to 2
};

/// Model of the spread of light; docs/theory.md has the equations, and the distance of each from the truth.
enum class ProfileModel : std::uint8_t {
  dipole,       ///< of a half-space [JMLH01]
  better,       ///< the better dipole; leaves out light that scattered only once
  multipole,    ///< of layers
  beam,         ///< photon beam diffusion
  monte_carlo,  ///< photons, seconds
  automatic     ///< the cheapest that is right for the coefficients
};

/// Measure by which a fit of Gaussians is best.
enum class ProfileFit : std::uint8_t {
  plane,  ///< R(r) over the plane, [JG08] eq. 2: the core, where most of the light leaves
  energy  ///< the light that leaves within r, at each r on a logarithmic scale: core and tail alike
};

/// Options of the computation.
struct ProfileOptions {
  int gaussians = 6;  ///< 1 to 8
  ProfileModel model = ProfileModel::automatic;
  ProfileFit fit = ProfileFit::plane;
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

/// R(r) as the model computed it, with its noise, at 24 radii per decade that tables of all profiles share.
/// Up to 3 s where skin has layers, else milliseconds. Throws InputError if the profile has no model_curves,
/// Cancelled if a hook ends the work.
ProfileTable model_table(const ScatterProfile& profile, const Hooks& hooks = {});

/// R(r) of the fit [1/mm^2], per channel, r_mm >= 0: the equation above. Its integral over the plane is
/// total_reflectance.
std::array<double, 3> reflectance(const ScatterProfile& profile, double r_mm);

/// Throws InputError if no picture can be made with the profile. So it must have 1 to 8 terms with variances
/// > 0 that rise, and weights >= 0 that sum to 1 per channel. Totals lie within 0..1, and all numbers are
/// finite. Every function that takes a profile calls it.
void check_profile(const ScatterProfile& profile);

/// A published profile by name ("skin"), else a profile file; with the checks of `render --profile`.
/// `normalise` divides weights by their sum.
ScatterProfile load_profile(const std::string& name_or_path, bool normalise = false);
/// The profile file that render --profile takes, atomically.
void write_profile(const ScatterProfile& profile, const std::string& path);

}  // namespace dermis
