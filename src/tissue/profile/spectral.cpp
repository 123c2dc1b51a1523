// SPDX-License-Identifier: MIT
#include "tissue/profile/spectral.h"

#include <algorithm>
#include <cmath>
#include <tuple>
#include <utility>

#include "base/core/channels.h"
#include "base/core/error.h"
#include "base/core/hooks.h"
#include "base/settings/check.h"
#include "base/settings/names.h"
#include "base/settings/profile_fields.h"
#include "tissue/optics/observer.h"
#include "tissue/optics/skin_colour.h"
#include "tissue/profile/slab.h"

namespace dermis::profile {
namespace {

constexpr double first_nm = 400, step_nm = 10;
constexpr std::size_t samples = spectral_samples;

double sample_nm(std::size_t i) { return first_nm + step_nm * static_cast<double>(i); }

/// Returns the 81 weights of each channel, each shared between the two samples beside it.
std::vector<optics::Rgb> sample_weights() {
  std::vector<optics::Rgb> weights(samples);
  const auto nm = optics::wavelengths_nm();
  for (std::size_t i = 0; i < nm.size(); ++i) {
    const double position = std::clamp((nm[i] - first_nm) / step_nm, 0.0, static_cast<double>(samples - 1));
    const std::size_t below = std::min(static_cast<std::size_t>(position), samples - 2);
    const double part = position - static_cast<double>(below);
    for (int c = 0; c < 3; ++c) {
      weights[below][c] += (1 - part) * optics::rec709_weights()[i][c];
      weights[below + 1][c] += part * optics::rec709_weights()[i][c];
    }
  }
  return weights;
}

/// Returns a model for skin and the reason: diffusion needs a high albedo and thick layers at every
/// wavelength.
std::pair<Model, std::string> choose(const SpectralSkin& skin) {
  double albedo = 2, albedo_nm = 0, thickness = HUGE_VAL, thickness_nm = 0;
  for (std::size_t i = 0; i < samples; ++i)
    for (const optics::Layer& layer : optics::skin_layers(skin, sample_nm(i))) {
      const optics::Medium medium = layer.medium();
      if (medium.reduced_albedo() < albedo) {
        albedo = medium.reduced_albedo();
        albedo_nm = sample_nm(i);
      }
      const double optical = layer.thickness_mm * medium.sigma_t_reduced_per_mm();
      if (optical < thickness) {
        thickness = optical;
        thickness_nm = sample_nm(i);
      }
    }
  if (albedo >= diffusion_albedo && thickness < diffusion_thickness)
    return {Model::monte_carlo, fmt::format("model chosen: the epidermis measures {:.2f} mean free paths ({} "
                                            "nm), under {} where diffusion theory holds",
                                            thickness, thickness_nm, diffusion_thickness)};
  const bool high = albedo >= diffusion_albedo;
  return {high ? Model::multipole : Model::monte_carlo,
          fmt::format(
              "model chosen: the lowest reduced albedo is {:.3f} ({} nm), {} {} where diffusion theory holds",
              albedo, albedo_nm, high ? "not under" : "under", diffusion_albedo)};
}

}  // namespace

WeightedProfile::WeightedProfile(std::vector<Part> parts, double total, std::string name,
                                 const std::string& where)
    : parts_(std::move(parts)), name_(std::move(name)) {
  double own = 0;
  for (const Part& part : parts_) {
    own += part.weight * part.profile->total();
    inner_mm_ = std::min(inner_mm_, part.profile->inner_mm());
    outer_mm_ = std::max(outer_mm_, part.profile->outer_mm());
    exact_ = exact_ && part.profile->hankel_is_exact();
    pole_ = pole_ || part.profile->has_pole();
  }
  if (!(own > 0) || !(total > 0))
    throw input_error(where, "this skin is so saturated that a channel of linear Rec.709 is not above 0");
  for (Part& part : parts_) part.weight *= total / own;
}

double WeightedProfile::at(double radius_mm) const {
  double sum = 0;
  for (const Part& part : parts_) sum += part.weight * part.profile->at(radius_mm);
  return sum;
}

double WeightedProfile::standard_error_at(double radius_mm) const {
  double sum = 0;
  for (const Part& part : parts_)
    sum = std::hypot(sum, part.weight * part.profile->standard_error_at(radius_mm));
  return sum;
}

double WeightedProfile::hankel(double k_per_mm) const {
  double sum = 0;
  for (const Part& part : parts_) sum += part.weight * part.profile->hankel(k_per_mm);
  return sum;
}

double WeightedProfile::within(double radius_mm) const {
  double sum = 0;
  for (const Part& part : parts_) sum += part.weight * part.profile->within(radius_mm);
  return sum;
}

double WeightedProfile::quantile(double p) const {
  const double wanted = p * total();
  double low = std::log(1e-6 * inner_mm_), high = std::log(60 * outer_mm_);
  for (int step = 0; step < 60; ++step) {
    const double middle = (low + high) / 2;
    (within(std::exp(middle)) < wanted ? low : high) = middle;
  }
  return std::exp(high);
}

ModelledProfiles make_profiles(const SpectralSkin& skin, Model model, const MonteCarloOptions& options,
                               const std::string& where) {
  check_ranges(skin, where);
  // The caller's number, before it is shared among the wavelengths.
  check_member(&ProfileOptions::photons, static_cast<double>(options.photons));
  if (model == Model::dipole || model == Model::better || model == Model::beam)
    throw input_error("model", "'{}' knows no layers; spectral skin takes multipole, monte-carlo or auto",
                      name_of(model));

  ModelledProfiles out;
  out.model = model;
  if (model == Model::automatic) std::tie(out.model, out.reason) = choose(skin);

  MonteCarloOptions each = options;
  each.photons = std::max<std::uint64_t>(options.photons / 16, 1000);
  const auto weights = sample_weights();
  const optics::Rgb exact = optics::skin_reflectance(skin);
  std::array<std::vector<WeightedProfile::Part>, 3> parts;

  Steps wavelengths("spread of light in skin", samples);
  for (std::size_t i = 0; i < samples; ++i) {
    const optics::Layers layers = optics::skin_layers(skin, sample_nm(i));
    ProfilePtr one;
    if (out.model == Model::monte_carlo) {
      each.seed = options.seed * 1000 + i;  // independent noise per wavelength averages out
      one = std::make_shared<MonteCarloProfile>(scene_of(layers), each);
    } else {
      one = std::make_shared<LayeredProfile>(layers, LayeredProfile::Side::reflected, where);
    }
    for (int c = 0; c < 3; ++c) parts[c].push_back({weights[i][c], one});
    wavelengths.done();
  }

  const std::string name =
      out.model == Model::monte_carlo ? "Monte-Carlo, 31 wavelengths" : "multipole, 31 wavelengths";
  for (int c = 0; c < 3; ++c)
    out.profiles[c] = std::make_shared<WeightedProfile>(std::move(parts[c]), exact[c], name,
                                                        where + ": " + channel_names[c]);
  return out;
}

}  // namespace dermis::profile
