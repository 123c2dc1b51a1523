// SPDX-License-Identifier: MIT
// Implements include/dermis/profile.h.
#include <algorithm>

#include "api/scatter_profile.h"
#include "core/error.h"
#include "core/file.h"
#include "core/hooks.h"
#include "dermis/profile.h"
#include "gaussians/fit.h"
#include "gaussians/json.h"
#include "optics/presets.h"
#include "optics/skin_colour.h"
#include "profile/equivalent.h"
#include "profile/spectral.h"
#include "settings/check.h"
#include "settings/profile_fields.h"

namespace dermis {
namespace {

profile::MonteCarloOptions photons_of(const ProfileOptions& options) {
  return {.photons = options.photons, .seed = options.seed, .cache = {}};
}

}  // namespace

namespace api {
gaussians::SumOfGaussians sum_of(const ScatterProfile& from) {
  if (from.variances_mm2.size() != from.weights.size())
    throw input_error("profile", "{} variances and {} weights", from.variances_mm2.size(),
                      from.weights.size());
  gaussians::SumOfGaussians sum{.name = from.name,
                                .model = from.model,
                                .terms = {},
                                .total_reflectance = from.total_reflectance,
                                .error_percent = from.error_percent,
                                .mean_free_path_mm = from.mean_free_path_mm,
                                .diffuse_mean_free_path_mm = from.diffuse_mean_free_path_mm};
  for (std::size_t i = 0; i < from.weights.size(); ++i)
    sum.terms.push_back({from.variances_mm2[i], from.weights[i]});
  return sum;
}
}  // namespace api

namespace {

static_assert(std::get<0>(fields_of<ProfileOptions>).about.most == gaussians::max_terms);

/// Fits the profiles. `medium` is the modelled medium; if it is null, `eta` is the index of the surface.
ScatterProfile finish(const std::string& name, const profile::ModelledProfiles& made,
                      const optics::RgbMedium* medium, double eta, const ProfileOptions& options) {
  const gaussians::SumOfGaussians sum = gaussians::fit_shared(made.profiles, options.gaussians, name);
  ScatterProfile out{.name = name,
                     .model = made.profiles[0]->name(),
                     .variances_mm2 = {},
                     .weights = {},
                     .error_percent = sum.error_percent};

  for (const gaussians::Gaussian& term : sum.terms) {
    out.variances_mm2.push_back(term.variance_mm2);
    out.weights.push_back(term.weight);
  }

  for (int c = 0; c < 3; ++c) {
    const optics::Medium one =
        medium != nullptr ? (*medium)[c] : profile::equivalent_medium(*made.profiles[c], eta);
    const double diffuse_mm = one.diffuse_mean_free_path().mm;
    out.model_total[c] = sum.total_reflectance[c];
    out.total_reflectance[c] = std::min(out.model_total[c], 1.0);
    out.mean_free_path_mm[c] = one.mean_free_path().mm;
    out.diffuse_mean_free_path_mm[c] = diffuse_mm < 1e9 ? diffuse_mm : 0;
  }

  return out;
}

ScatterProfile of_medium(const std::string& name, const optics::RgbMedium& medium,
                         const ProfileOptions& options) {
  return finish(name, make_profiles(medium, options.model, photons_of(options), name), &medium, medium[0].eta,
                options);
}

}  // namespace

// All options are checked before the work: Monte-Carlo takes seconds.

ScatterProfile profile_of_preset(const std::string& name, const ProfileOptions& options, const Hooks& hooks) {
  const HookScope scope(hooks);
  check_ranges(options);
  if (name == "skin-layers") {
    const optics::RgbLayers skin = optics::donner_jensen_skin();
    return finish(name, make_profiles(skin, options.model, photons_of(options), name), nullptr,
                  skin.front().eta, options);
  }
  const optics::Material* material = optics::find_material(name);
  if (material == nullptr) optics::unknown_preset(name);
  return of_medium(name, material->medium(), options);
}

ScatterProfile profile_of_coefficients(const Coefficients& coefficients, const ProfileOptions& options,
                                       const Hooks& hooks) {
  const HookScope scope(hooks);
  check_ranges(options);
  check_ranges(coefficients);
  optics::RgbMedium medium;
  for (int c = 0; c < 3; ++c)
    medium[c] = {coefficients.sigma_a_per_mm[c], coefficients.sigma_s_per_mm[c], coefficients.g,
                 coefficients.eta};
  return of_medium("coefficients", medium, options);
}

ScatterProfile profile_of_skin(const SpectralSkin& skin, const ProfileOptions& options, const Hooks& hooks) {
  const HookScope scope(hooks);
  check_ranges(options);
  check_ranges(skin);
  const optics::Skin inner = optics::skin_of(skin);
  const std::string name = fmt::format("spectral skin, melanin {:.4g}", skin.melanin);
  return finish(name, make_profiles(inner, options.model, photons_of(options), name), nullptr, inner.eta,
                options);
}

SpectralSkin skin_of_colour(const std::string& colour, double* delta_e, const Hooks& hooks) {
  const HookScope scope(hooks);
  const optics::SkinMatch match = optics::nearest_skin(optics::parse_colour(colour, "colour"));
  if (delta_e != nullptr) *delta_e = match.delta_e;
  return optics::spectral_skin(match.skin);
}

void write_profile(const ScatterProfile& profile, const std::string& path) {
  write_file(path, gaussians::to_json(api::sum_of(profile)));
}

}  // namespace dermis
