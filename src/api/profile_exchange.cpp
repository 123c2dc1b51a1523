// SPDX-License-Identifier: MIT
// Implements include/dermis/profile_exchange.h.
#include "dermis/profile_exchange.h"

#include <cmath>

#include "api/profile_curves.h"
#include "base/core/error.h"
#include "base/core/hooks.h"
#include "base/settings/check.h"
#include "base/settings/names.h"
#include "tissue/gaussians/exchange.h"
#include "tissue/gaussians/fit.h"
#include "tissue/gaussians/kernel_export.h"
#include "tissue/gaussians/scatter_profile.h"
#include "tissue/profile/burley.h"
#include "tissue/profile/equivalent.h"
#include "tissue/profile/tabulated.h"

namespace dermis {
namespace {

constexpr double default_eta = 1.4;  // skin [JMLH01]: 1.3 to 1.5

/// A channel of a sum of Gaussians, as a curve.
class GaussianCurve final : public profile::RadialProfile {
 public:
  explicit GaussianCurve(std::vector<gaussians::Term> terms) : terms_(std::move(terms)) {}

  double at(double radius_mm) const override { return gaussians::evaluate(terms_, radius_mm); }
  double hankel(double k_per_mm) const override {
    double sum = 0;
    for (const gaussians::Term& term : terms_)
      sum += term.weight * std::exp(-term.variance_mm2 * k_per_mm * k_per_mm / 2);
    return sum;
  }
  double inner_mm() const override { return std::sqrt(terms_.front().variance_mm2); }
  double outer_mm() const override { return std::sqrt(terms_.back().variance_mm2); }
  bool hankel_is_exact() const override { return true; }
  std::string name() const override { return "sum of Gaussians"; }

 private:
  std::vector<gaussians::Term> terms_;
};

std::vector<std::string> strings_of(const std::vector<std::string_view>& names) {
  return {names.begin(), names.end()};
}

void only_automatic(const ProfileOptions& options, const char* source) {
  if (options.model != ProfileModel::automatic)
    throw input_error("", "model '{}' is not for {}, which brings its own profile", name_of(options.model),
                      source);
}

}  // namespace

std::vector<std::string> exchange_systems() { return strings_of(gaussians::exchange_names()); }
std::vector<std::string> kernel_names() { return strings_of(gaussians::kernel_names()); }

std::string export_profile(const ScatterProfile& profile, const std::string& system) {
  const ScatterProfile sum = gaussians::checked_profile(profile);
  gaussians::Exported input{.name = profile.name, .profiles = {}, .terms = {}, .medium = {}};
  for (int c = 0; c < 3; ++c) {
    for (const Gaussian& term : sum.terms) input.terms[c].push_back({term.variance_mm2, term.weight[c]});
    input.profiles[c] = profile.model_curves ? profile.model_curves->profiles[c]
                                             : std::make_shared<GaussianCurve>(gaussians::channel(sum, c));
  }

  if (profile.medium) {
    input.medium = optics::rgb_medium(*profile.medium);
  } else {
    for (int c = 0; c < 3; ++c) input.medium[c] = profile::equivalent_medium(*input.profiles[c], default_eta);
  }
  return gaussians::export_text(system, input);
}

ProfileKernel export_kernel(const ScatterProfile& profile, const std::string& kernel,
                            std::optional<int> taps) {
  const gaussians::ExportedKernel made =
      gaussians::export_kernel(kernel, gaussians::checked_profile(profile), taps);
  return {.json = made.json, .c = made.c, .glsl = made.glsl};
}

ScatterProfile profile_of_table(const std::string& name, const std::vector<double>& r_mm,
                                const std::vector<std::array<double, 3>>& reflectance_per_mm2,
                                const ProfileOptions& options, const Hooks& hooks) {
  const HookScope scope(hooks);
  check_ranges(options);
  only_automatic(options, "a table");
  if (reflectance_per_mm2.size() != r_mm.size())
    throw input_error(name, "reflectance_per_mm2 must have as many rows as r_mm, {}, has {}", r_mm.size(),
                      reflectance_per_mm2.size());

  profile::ModelledProfiles made;
  for (int c = 0; c < 3; ++c) {
    std::vector<double> values;
    for (const std::array<double, 3>& row : reflectance_per_mm2) values.push_back(row[c]);
    made.profiles[c] = std::make_shared<profile::Tabulated>(r_mm, std::move(values), name);
    if (made.profiles[c]->total() > 1.0001)
      throw input_error(name, "channel {} reflects {:.4g} times what enters; is R in 1/mm^2, and r in mm?", c,
                        made.profiles[c]->total());
  }
  return api::fitted_profile(name, made, nullptr, default_eta, options);
}

ScatterProfile profile_of_import(const std::string& text, const ProfileOptions& options, const Hooks& hooks) {
  const HookScope scope(hooks);
  check_ranges(options);
  const gaussians::Imported imported = gaussians::parse_import(text, "import");
  if (!imported.is_burley) return api::profile_of_medium(imported.name, imported.medium, options);

  only_automatic(options, "an import of a Burley profile");
  profile::ModelledProfiles made;
  for (int c = 0; c < 3; ++c)
    made.profiles[c] = std::make_shared<profile::Burley>(imported.total_reflectance[c],
                                                         imported.burley_shape_mm[c], "import");
  return api::fitted_profile(imported.name, made, nullptr, default_eta, options);
}

}  // namespace dermis
