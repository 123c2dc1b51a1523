// SPDX-License-Identifier: MIT
#include "cli/profile_source.h"

#include <CLI/CLI.hpp>
#include <cmath>
#include <filesystem>

#include "base/core/error.h"
#include "base/settings/check.h"
#include "base/settings/names.h"
#include "base/settings/profile_fields.h"
#include "head/pigments/maps.h"
#include "head/scene/gltf/load.h"
#include "image/codec.h"
#include "tissue/gaussians/exchange.h"
#include "tissue/optics/inversion.h"
#include "tissue/optics/presets.h"
#include "tissue/optics/skin_colour.h"
#include "tissue/profile/burley.h"
#include "tissue/profile/equivalent.h"
#include "tissue/profile/spectral.h"
#include "tissue/profile/tabulated.h"

namespace dermis::cli {
namespace {

constexpr double default_eta = 1.4;  // skin [JMLH01]: 1.3 to 1.5

/// "auto" decides; anything else must be a model that knows the source.
void only_automatic(const SourceOptions& options, const char* source) {
  if (options.profile.model != ProfileModel::automatic)
    throw input_error("--model", "'{}' is not for {}, which brings its own profile",
                      name_of(options.profile.model), source);
}

Source from_models(std::string name, profile::ModelledProfiles modelled) {
  Source source{.name = std::move(name),
                .model = modelled.profiles[0]->name(),
                .note = modelled.reason,
                .profiles = modelled.profiles,
                .medium = {},
                .skin = {}};
  if (modelled.model == profile::Model::better)
    source.note =
        "the better dipole leaves light out that scattered only once: totals and the core are too low, most "
        "where skin absorbs most";
  return source;
}

void summarise(Source& source, double eta = default_eta) {
  for (int c = 0; c < 3; ++c) source.medium[c] = profile::equivalent_medium(*source.profiles[c], eta);
  source.equivalent = true;
}

profile::MonteCarloOptions monte_carlo(const SourceOptions& options) {
  return {.photons = options.profile.photons, .seed = options.profile.seed, .cache = options.cache};
}

Source from_medium(const std::string& name, const optics::RgbMedium& medium, const SourceOptions& options,
                   const std::string& where) {
  Source source =
      from_models(name, make_profiles(medium, options.profile.model, monte_carlo(options), where));
  source.medium = medium;
  return source;
}

Source from_layers(const std::string& name, const optics::RgbLayers& layers, const SourceOptions& options,
                   const std::string& where) {
  Source source =
      from_models(name, make_profiles(layers, options.profile.model, monte_carlo(options), where));
  summarise(source, layers.front().eta);  // the surface that light meets
  return source;
}

Source from_preset(const SourceOptions& options) {
  if (options.preset == "skin-layers")
    return from_layers(options.preset, optics::donner_jensen_skin(), options, "--preset skin-layers");
  const optics::Material* material = optics::find_material(options.preset);
  if (material == nullptr) optics::unknown_preset(options.preset);
  return from_medium(options.preset, material->medium(), options, "--preset " + options.preset);
}

Source from_csv(const SourceOptions& options) {
  only_automatic(options, "a table");
  Source source{.name = std::filesystem::path(options.csv).stem().string(),
                .model = "table",
                .note = {},
                .profiles = profile::load_csv(options.csv),
                .medium = {},
                .skin = {}};
  constexpr const char* column[] = {"R", "G", "B"};
  for (int c = 0; c < 3; ++c)
    if (source.profiles[c]->total() > 1.0001)
      throw input_error(options.csv,
                        "column {} reflects {:.4g} times what enters; is R in 1/mm^2, and r in mm?",
                        column[c], source.profiles[c]->total());
  summarise(source);
  return source;
}

Source from_burley(const SourceOptions& options) {
  only_automatic(options, "--burley");
  const profile::BurleyDescription burley = profile::parse_burley(options.burley, "--burley");
  Source source{.name = "burley", .model = "Burley", .note = {}, .profiles = {}, .medium = {}, .skin = {}};
  for (int c = 0; c < 3; ++c)
    source.profiles[c] =
        std::make_shared<profile::Burley>(burley.total_reflectance[c], burley.shape_mm[c], "--burley");
  summarise(source);
  return source;
}

Source from_import(const SourceOptions& options) {
  const gaussians::Imported imported = gaussians::parse_import(options.import, "--import");
  if (!imported.is_burley) return from_medium(imported.name, imported.medium, options, "--import");
  only_automatic(options, "--import of a Burley profile");
  Source source{
      .name = imported.name, .model = "Burley", .note = {}, .profiles = {}, .medium = {}, .skin = {}};
  for (int c = 0; c < 3; ++c)
    source.profiles[c] = std::make_shared<profile::Burley>(imported.total_reflectance[c],
                                                           imported.burley_shape_mm[c], "--import");
  summarise(source);
  return source;
}

/// Returns `skin` with the values of the options.
SpectralSkin refined(SpectralSkin skin, const SourceOptions& options) {
  const auto one = [&](const auto& field) {
    if (options.given.contains(std::string(field.name))) skin.*field.member = options.skin.*field.member;
  };
  std::apply([&](const auto&... field) { (one(field), ...); }, fields_of<SpectralSkin>);

  check_ranges(skin);
  return skin;
}

Source from_skin(const std::string& name, const SpectralSkin& skin, const SourceOptions& options) {
  Source source = from_models(name, make_profiles(skin, options.profile.model, monte_carlo(options), "skin"));
  source.skin = skin;
  summarise(source, optics::skin_eta);
  return source;
}

Source from_colour(const SourceOptions& options) {
  if (options.given.contains("haemoglobin"))
    throw input_error("--hemoglobin", "--colour finds melanin and hemoglobin itself");
  const optics::Lab wanted = optics::parse_colour(options.colour, "--colour");
  const optics::SkinMatch match = optics::nearest_skin(wanted, refined(optics::measured_skin(), options));
  Source source = from_skin("colour " + options.colour, match.skin, options);
  source.note += fmt::format(
      "{}nearest skin: melanin {:.4f}, hemoglobin {:.4f}; L*a*b* {:.1f} {:.1f} {:.1f}, {:.1f} dE (CIE76) "
      "from the colour asked for",
      source.note.empty() ? "" : "\n", match.skin.melanin, match.skin.haemoglobin, match.lab.l, match.lab.a,
      match.lab.b, match.delta_e);
  return source;
}

// Maps are made for one skin; what is refined would be another.
Source from_head(const SourceOptions& options) {
  if (!options.given.empty())
    throw input_error("--head",
                      "finds the skin itself: --melanin, --hemoglobin, --blend, --oxygenation and "
                      "--epidermis-mm do not go with it");
  const pigments::Maps maps =
      pigments::maps_of(scene::load_gltf(options.head, {.skin_material = options.skin_material}));
  if (!options.melanin_map.empty()) image::save_png(options.melanin_map, maps.melanin);
  if (!options.haemoglobin_map.empty()) image::save_png(options.haemoglobin_map, maps.haemoglobin);

  SpectralSkin skin = optics::measured_skin();
  skin.melanin = maps.mean.melanin;
  skin.haemoglobin = maps.mean.haemoglobin;
  Source source = from_skin("head " + std::filesystem::path(options.head).filename().string(), skin, options);
  source.note += fmt::format(
      "{}mean skin of '{}', {} texels, exposure {:+.2f} EV: melanin {:.4f}, hemoglobin {:.4f}\n"
      "colour map against the two pigments alone: {:.2f} dE (CIE76) on average, {:.2f} at 95 %; against what "
      "render makes of the maps: {:.2f} and {:.2f}",
      source.note.empty() ? "" : "\n", maps.material, maps.texels, std::log2(maps.exposure), skin.melanin,
      skin.haemoglobin, maps.model_delta_e.mean, maps.model_delta_e.p95, maps.colour_delta_e.mean,
      maps.colour_delta_e.p95);
  return source;
}

void check_refinements(const SourceOptions& options) {
  const bool refines = !options.given.empty();
  if (refines && !options.given.contains("melanin") && options.colour.empty() && options.head.empty())
    throw CLI::RequiredError(
        "--blend, --hemoglobin, --oxygenation and --epidermis-mm refine --melanin or --colour, one of which");
}

}  // namespace

Source open_source(const SourceOptions& options) {
  struct Choice {
    const char* option;
    const std::string& value;
    Source (*open)(const SourceOptions&);
  };

  check_refinements(options);

  // Give melanin a text, too: an empty one says that the option was not given.
  const std::string melanin = options.given.contains("melanin") && options.head.empty() ? "given" : "";
  const bool wants_maps = !options.melanin_map.empty() || !options.haemoglobin_map.empty();
  if (options.head.empty() && (wants_maps || !options.skin_material.empty()))
    throw CLI::RequiredError("--melanin-map, --haemoglobin-map and --skin are of a head: --head");
  const Choice choices[] = {
      {"--preset", options.preset, from_preset},
      {"--coefficients", options.coefficients,
       [](const SourceOptions& o) {
         return from_medium("coefficients", optics::parse_coefficients(o.coefficients, "--coefficients"), o,
                            "--coefficients");
       }},
      {"--layers", options.layers,
       [](const SourceOptions& o) {
         return from_layers(std::filesystem::path(o.layers).stem().string(), optics::load_layers(o.layers), o,
                            o.layers);
       }},
      {"--melanin", melanin,
       [](const SourceOptions& o) {
         return from_skin(fmt::format("spectral skin, melanin {:.4g}", o.skin.melanin), refined({}, o), o);
       }},
      {"--colour", options.colour, from_colour},
      {"--head", options.head, from_head},
      {"--burley", options.burley, from_burley},
      {"--csv", options.csv, from_csv},
      {"--import", options.import, from_import},
  };

  const Choice* chosen = nullptr;
  std::string all;
  for (const Choice& choice : choices) {
    all += std::string(all.empty() ? "" : ", ") + choice.option;
    if (choice.value.empty()) continue;
    if (chosen != nullptr) throw CLI::ExcludesError(chosen->option, choice.option);
    chosen = &choice;
  }

  if (chosen == nullptr) throw CLI::RequiredError("one source of " + all);
  return chosen->open(options);
}

}  // namespace dermis::cli
