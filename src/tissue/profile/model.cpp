// SPDX-License-Identifier: MIT
#include "tissue/profile/model.h"

#include <fmt/ranges.h>

#include "base/core/channels.h"
#include "base/core/error.h"
#include "base/core/hooks.h"
#include "base/settings/names.h"
#include "tissue/profile/beam.h"
#include "tissue/profile/dipole.h"
#include "tissue/profile/slab.h"

namespace dermis::profile {
namespace {

ProfilePtr homogeneous(const optics::Medium& medium, Model model, const MonteCarloOptions& options) {
  switch (model) {
    case Model::better: return std::make_shared<BetterDipole>(medium);
    case Model::beam: return std::make_shared<PhotonBeam>(medium);
    case Model::monte_carlo: return std::make_shared<MonteCarloProfile>(scene_of(medium), options);
    default: return std::make_shared<Dipole>(medium);  // the multipole of a half-space is the dipole
  }
}

/// Throws InputError if a channel reflects nothing: such a profile has no shape.
void check_reflects(const ModelledProfiles& made, const std::string& where) {
  for (int c = 0; c < 3; ++c)
    if (!(made.profiles[c]->total() > 0))
      throw input_error(fmt::format("{}: {}", where, channel_names[c]),
                        "reflects nothing, so there is no profile: sigma_s must be above 0");
}

}  // namespace

ModelledProfiles make_profiles(const optics::RgbMedium& medium, Model model, const MonteCarloOptions& options,
                               const std::string& where) {
  optics::check(medium, where);
  ModelledProfiles out;
  out.model = model;
  if (model == Model::automatic) {
    int lowest = 0;
    for (int c = 1; c < 3; ++c)
      if (medium[c].reduced_albedo() < medium[lowest].reduced_albedo()) lowest = c;
    const double albedo = medium[lowest].reduced_albedo();
    out.model = albedo >= diffusion_albedo ? Model::dipole : Model::monte_carlo;
    out.reason = fmt::format(
        "model chosen: the lowest reduced albedo is {:.3f} ({}), {} {} where diffusion theory holds", albedo,
        channel_names[lowest], albedo >= diffusion_albedo ? "not under" : "under", diffusion_albedo);
  }

  Steps channels("spread of light in skin", 3);
  for (int c = 0; c < 3; ++c) {
    out.profiles[c] = homogeneous(medium[c], out.model, options);
    channels.done();
  }

  check_reflects(out, where);
  return out;
}

ModelledProfiles make_profiles(const optics::RgbLayers& layers, Model model, const MonteCarloOptions& options,
                               const std::string& where) {
  if (model == Model::dipole || model == Model::better || model == Model::beam)
    throw input_error("model", "'{}' knows no layers; layers take multipole, monte-carlo or auto",
                      name_of(model));

  ModelledProfiles out;
  out.model = model;

  // Finds the lowest reduced albedo, the thinnest layer, and where they are.
  double lowest = 2, thinnest = 1e300;
  std::string place, thin_place;
  for (int c = 0; c < 3; ++c) {
    const optics::Layers one = optics::channel(layers, c);
    optics::check(one, where);
    for (std::size_t i = 0; i < one.size(); ++i) {
      const double optical = one[i].thickness_mm * one[i].medium().sigma_t_reduced_per_mm();
      if (optical < thinnest) {
        thinnest = optical;
        thin_place = fmt::format("layer {}, {}", i, channel_names[c]);
      }
      if (one[i].medium().reduced_albedo() >= lowest) continue;
      lowest = one[i].medium().reduced_albedo();
      place = fmt::format("layer {}, {}", i, channel_names[c]);
    }
  }

  if (model == Model::automatic) {
    const bool thin = thinnest < diffusion_thickness;
    out.model = lowest >= diffusion_albedo && !thin ? Model::multipole : Model::monte_carlo;
    if (lowest >= diffusion_albedo && thin)
      out.reason = fmt::format(
          "model chosen: the thinnest layer measures {:.2f} mean free paths ({}), under {} where diffusion "
          "theory holds",
          thinnest, thin_place, diffusion_thickness);
    else
      out.reason = fmt::format(
          "model chosen: the lowest reduced albedo is {:.3f} ({}), {} {} where diffusion theory holds",
          lowest, place, lowest >= diffusion_albedo ? "not under" : "under", diffusion_albedo);
  }

  Steps channels("spread of light in skin", 3);
  for (int c = 0; c < 3; ++c) {
    const optics::Layers one = optics::channel(layers, c);
    if (out.model == Model::monte_carlo)
      out.profiles[c] = std::make_shared<MonteCarloProfile>(scene_of(one), options);
    else
      out.profiles[c] = std::make_shared<LayeredProfile>(one, LayeredProfile::Side::reflected, where);
    channels.done();
  }

  check_reflects(out, where);
  return out;
}

}  // namespace dermis::profile
