// SPDX-License-Identifier: MIT
// Implements include/dermis/profile.h.
#include <algorithm>

#include "api/profile_curves.h"
#include "base/core/error.h"
#include "base/core/file.h"
#include "base/core/hooks.h"
#include "base/core/one_line.h"
#include "base/settings/check.h"
#include "base/settings/profile_fields.h"
#include "dermis/profile.h"
#include "tissue/gaussians/fit.h"
#include "tissue/gaussians/json.h"
#include "tissue/gaussians/scatter_profile.h"
#include "tissue/optics/presets.h"
#include "tissue/optics/skin_colour.h"
#include "tissue/profile/equivalent.h"
#include "tissue/profile/noise.h"
#include "tissue/profile/shape_laws.h"
#include "tissue/profile/spectral.h"
#include "tissue/profile/table.h"

namespace dermis {

namespace {

profile::MonteCarloOptions photons_of(const ProfileOptions& options) {
  return {.photons = options.photons, .seed = options.seed, .cache = {}};
}

static_assert(std::get<0>(fields_of<ProfileOptions>).about.most == gaussians::max_terms);

}  // namespace

ScatterProfile api::fitted_profile(const std::string& name, const profile::ModelledProfiles& made,
                                   const optics::RgbMedium* medium, double eta,
                                   const ProfileOptions& options) {
  const ScatterProfile sum = gaussians::fit_shared(made.profiles, options.gaussians, name, options.fit);
  ScatterProfile out = sum;
  out.model = made.profiles[0]->name();
  out.model_reason = made.reason;
  out.model_curves = std::make_shared<const ModelCurves>(made.profiles);

  optics::RgbMedium made_of;
  for (int c = 0; c < 3; ++c) {
    made_of[c] = medium != nullptr ? (*medium)[c] : profile::equivalent_medium(*made.profiles[c], eta);
    const optics::Medium& one = made_of[c];
    const double diffuse_mm = one.diffuse_mean_free_path().mm;
    out.model_total[c] = sum.total_reflectance[c];
    out.total_reflectance[c] = std::min(out.model_total[c], 1.0);
    out.mean_free_path_mm[c] = one.mean_free_path().mm;
    out.diffuse_mean_free_path_mm[c] = diffuse_mm < 1e9 ? diffuse_mm : 0;
    if (const auto sampled = profile::sampled(*made.profiles[c])) {
      out.noise_percent[c] = sampled->noise_percent;
      out.missing_light[c] = sampled->cut;
    }
  }

  out.medium = optics::coefficients_of(made_of);
  if (out.medium) out.shape = profile::shape_laws(made_of);
  return out;
}

ScatterProfile api::profile_of_medium(const std::string& name, const optics::RgbMedium& medium,
                                      const ProfileOptions& options) {
  return fitted_profile(name, make_profiles(medium, options.model, photons_of(options), name), &medium,
                        medium[0].eta, options);
}

// All options are checked before the work: Monte-Carlo takes seconds.

ScatterProfile profile_of_preset(const std::string& name, const ProfileOptions& options, const Hooks& hooks) {
  const HookScope scope(hooks);
  check_ranges(options);
  if (name == "skin-layers") {
    const optics::RgbLayers skin = optics::donner_jensen_skin();
    return api::fitted_profile(name, make_profiles(skin, options.model, photons_of(options), name), nullptr,
                               skin.front().eta, options);
  }
  const optics::Material* material = optics::find_material(name);
  if (material == nullptr) optics::unknown_preset(name);
  return api::profile_of_medium(name, material->medium(), options);
}

ScatterProfile profile_of_coefficients(const Coefficients& coefficients, const ProfileOptions& options,
                                       const Hooks& hooks) {
  const HookScope scope(hooks);
  check_ranges(options);
  check_ranges(coefficients);
  return api::profile_of_medium("coefficients", optics::rgb_medium(coefficients), options);
}

ScatterProfile profile_of_skin(const SpectralSkin& skin, const ProfileOptions& options, const Hooks& hooks) {
  const HookScope scope(hooks);
  check_ranges(options);
  check_ranges(skin);
  const std::string name = fmt::format("spectral skin, melanin {:.4g}", skin.melanin);
  return api::fitted_profile(name, make_profiles(skin, options.model, photons_of(options), name), nullptr,
                             optics::skin_eta, options);
}

SpectralSkin skin_of_colour(const std::string& colour, double* delta_e, const Hooks& hooks) {
  const HookScope scope(hooks);
  const optics::SkinMatch match = optics::nearest_skin(optics::parse_colour(colour, "colour"));
  if (delta_e != nullptr) *delta_e = match.delta_e;
  return match.skin;
}

ProfileTable model_table(const ScatterProfile& profile, const Hooks& hooks) {
  const HookScope scope(hooks);
  if (profile.model_curves == nullptr)
    throw input_error("", "profile '{}' has no curves of a model: it was read, or put together by hand",
                      one_line(profile.name, 80));
  return profile::table_of(profile.model_curves->profiles);
}

std::array<double, 3> reflectance(const ScatterProfile& profile, double r_mm) {
  const ScatterProfile sum = gaussians::checked_profile(profile);
  if (!(r_mm >= 0)) throw input_error("", "r_mm must be >= 0, got {}", r_mm);
  std::array<double, 3> values{};
  for (int c = 0; c < 3; ++c) values[c] = gaussians::evaluate(gaussians::channel(sum, c), r_mm);
  return values;
}

void check_profile(const ScatterProfile& profile) { gaussians::checked_profile(profile); }

ScatterProfile load_profile(const std::string& name_or_path, bool normalise) {
  return gaussians::from_name_or_file(name_or_path, normalise);
}

void write_profile(const ScatterProfile& profile, const std::string& path) {
  write_file(path, gaussians::to_json(gaussians::checked_profile(profile)));
}

}  // namespace dermis
