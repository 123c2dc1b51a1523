// SPDX-License-Identifier: MIT
#include "viewer/model/skin_maker.h"

#include <fmt/format.h>

#include <chrono>
#include <cmath>

#include "base/core/cache.h"
#include "base/core/error.h"
#include "base/core/hooks.h"
#include "base/core/parallel.h"
#include "base/settings/profile_fields.h"
#include "cli/profile_report.h"
#include "tissue/gaussians/json.h"
#include "tissue/gaussians/scatter_profile.h"

namespace dermis::viewer {
namespace {

// From a thousandth of a mm to beyond where skin sends light back.
constexpr double first_mm = 1e-2, last_mm = 30;
constexpr int radii = 120;

std::string rgb(const std::array<double, 3>& v) { return fmt::format("{},{},{}", v[0], v[1], v[2]); }

// A description of another engine may bring its own profile, for which no model is chosen.
bool wants_photons(const SkinSource& source) {
  if (source.kind == SkinKind::foreign) return false;
  return source.options.model == ProfileModel::automatic || source.options.model == ProfileModel::monte_carlo;
}

bool has_layers(const SkinSource& source) {
  return source.kind == SkinKind::spectral ||
         (source.kind == SkinKind::preset && source.preset == "skin-layers");
}

cli::Source open(const SkinSource& source, bool quick) {
  cli::SourceOptions options = source_options(source);
  if (quick && wants_photons(source))
    options.profile.model = has_layers(source) ? ProfileModel::multipole : ProfileModel::dipole;
  return cli::open_source(options);
}

// Where skin has layers, R(r) at one radius takes milliseconds.
void add_model(SkinCurves& curves, const cli::Source& source) {
  curves.model.resize(curves.r_mm.size());
  curves.standard_error.resize(curves.r_mm.size());
  parallel_for(curves.r_mm.size(), [&](std::size_t i) {
    for (std::size_t c = 0; c < 3; ++c) {
      curves.model[i][c] = source.profiles[c]->at(curves.r_mm[i]);
      curves.standard_error[i][c] = source.profiles[c]->standard_error_at(curves.r_mm[i]);
    }
  });
}

const cli::Source& medium_of(const MadeSkin& skin) {
  if (!skin.source) throw InputError("skin", "Gaussians alone have no medium; make the skin of one");
  return *skin.source;
}

cli::Fitted fit_of(const MadeSkin& skin) {
  return cli::fit(medium_of(skin), static_cast<int>(skin.profile.terms.size()), true);
}

}  // namespace

cli::SourceOptions source_options(const SkinSource& source) {
  cli::SourceOptions options;
  options.profile = source.options;
  options.cache = cache::default_folder();
  switch (source.kind) {
    case SkinKind::preset: options.preset = source.preset; break;
    case SkinKind::spectral:
      options.skin = source.spectral;
      std::apply([&](const auto&... field) { (options.given.emplace(field.name), ...); },
                 fields_of<SpectralSkin>);
      break;
    case SkinKind::coefficients:
      options.coefficients = fmt::format(
          "sigma_a={} sigma_s={} g={} eta={}", rgb(source.coefficients.sigma_a_per_mm),
          rgb(source.coefficients.sigma_s_per_mm), source.coefficients.g, source.coefficients.eta);
      break;
    case SkinKind::foreign: options.import = source.foreign; break;
    case SkinKind::scene:
    case SkinKind::gaussians: break;
  }
  return options;
}

SkinCurves curves_of(const ScatterProfile& profile) {
  SkinCurves curves;
  for (int i = 0; i < radii; ++i) {
    curves.r_mm.push_back(first_mm * std::pow(last_mm / first_mm, i / (radii - 1.0)));
    curves.fit.push_back(reflectance(profile, curves.r_mm.back()));
  }
  return curves;
}

bool needs_better(const SkinSource& source) {
  if (source.kind == SkinKind::scene || source.kind == SkinKind::gaussians) return false;
  return wants_photons(source) || has_layers(source);
}

MadeSkin make_skin(const SkinSource& source, bool quick, const Hooks& hooks) {
  const HookScope scope(hooks);
  const auto start = std::chrono::steady_clock::now();
  MadeSkin made;
  if (source.kind == SkinKind::gaussians) {
    check_profile(source.gaussians);
    made.profile = source.gaussians;
    made.model = "Gaussians";
  } else {
    made.source = open(source, quick);
    // The file that `dermis profile` would write, read back: equal to the bit.
    const cli::Fitted fitted = cli::fit(*made.source, source.options.gaussians, true);
    made.profile = gaussians::parse_json(cli::profile_json(*made.source, fitted), made.source->name);
    made.model = made.source->model;
    made.note = made.source->note;
  }
  made.curves = curves_of(made.profile);
  if (made.source && !(quick && has_layers(source))) add_model(made.curves, *made.source);
  made.is_quick = quick && needs_better(source);
  made.ms = std::chrono::duration<double, std::milli>(std::chrono::steady_clock::now() - start).count();
  return made;
}

std::string exported_skin(const MadeSkin& skin, const std::string& system) {
  return cli::exported(medium_of(skin), fit_of(skin), system);
}

std::string plotted_skin(const MadeSkin& skin) {
  const cli::Source& source = medium_of(skin);
  return cli::profile_svg({.title = source.name + ": " + source.model,
                           .profiles = source.profiles,
                           .fit = cli::plotted(fit_of(skin)),
                           .others = {}});
}

void SkinMaker::want(const SkinSource& source) {
  next_ = Wish{.source = source, .quick = true};
  if (!under_way_.quick) work_.end();
  start();
}

void SkinMaker::start() {
  if (!next_ || work_.is_running()) return;
  under_way_ = *std::exchange(next_, {});
  work_.start([wish = under_way_](const Hooks& hooks) { return make_skin(wish.source, wish.quick, hooks); },
              under_way_.quick ? Priority::hand : Priority::background);
}

std::optional<MadeSkin> SkinMaker::take() {
  std::optional<Outcome<MadeSkin>> outcome = work_.take();
  if (outcome) {
    error_ = outcome->error;
    if (outcome->result && under_way_.quick && !next_ && needs_better(under_way_.source))
      next_ = Wish{.source = under_way_.source, .quick = false};
  }
  start();
  return outcome ? std::move(outcome->result) : std::nullopt;
}

}  // namespace dermis::viewer
