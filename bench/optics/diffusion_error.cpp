// SPDX-License-Identifier: MIT
// Prints how far each diffusion model is from Monte-Carlo, as the table of docs/theory.md. Takes a minute.
#include <fmt/format.h>

#include <cmath>
#include <cstdio>
#include <limits>
#include <numbers>
#include <string>
#include <vector>

#include "tissue/optics/presets.h"
#include "tissue/optics/skin.h"
#include "tissue/profile/beam.h"
#include "tissue/profile/dipole.h"
#include "tissue/profile/monte_carlo.h"
#include "tissue/profile/slab.h"

namespace {

using namespace dermis;
using std::numbers::pi;

/// Bounds of the rings in which light is compared: geometric, each labelled by its middle.
constexpr double middles_mm[] = {0.2, 0.5, 1, 2, 5, 10};
constexpr double half_width = 1.25;

/// Mean of R over the ring, by Gauss in log r.
double ring_mean(const profile::RadialProfile& profile, double middle) {
  double energy = 0;
  constexpr int steps = 40;
  const double low = std::log(middle / half_width), h = 2 * std::log(half_width) / steps;
  for (int i = 0; i < steps; ++i) {
    const double r = std::exp(low + (i + 0.5) * h);
    energy += 2 * pi * r * r * profile.at(r) * h;
  }
  return energy / (pi * middle * middle * (half_width * half_width - 1 / (half_width * half_width)));
}

void row(const std::string& what, const std::string& model, const profile::RadialProfile& profile,
         const profile::MonteCarloProfile& truth) {
  std::string text =
      fmt::format("| {} | {} | {:+.1f} |", what, model, 100 * (profile.total() / truth.total() - 1));
  for (const double middle : middles_mm) {
    const double exact = ring_mean(truth, middle);
    // Where hardly a photon left there is nothing to compare with.
    const bool known = truth.total() - truth.within(middle / half_width) > 3e-5;
    text += known && exact > 0 ? fmt::format(" {:+.0f} |", 100 * (ring_mean(profile, middle) / exact - 1))
                               : " - |";
  }
  std::puts(text.c_str());
}

}  // namespace

int main() {
  std::puts(
      "| medium | model | total % | 0.2 mm | 0.5 mm | 1 mm | 2 mm | 5 mm | 10 mm "
      "|\n|---|---|---|---|---|---|---|---|---|");

  const profile::MonteCarloOptions options{.photons = 2'000'000, .seed = 1, .cache = {}};
  constexpr const char* channel[] = {"red", "green", "blue"};

  for (const char* name : {"skin1", "skin2"}) {
    const auto media = optics::find_material(name)->medium();
    for (int c = 0; c < 3; ++c) {
      const std::string what =
          fmt::format("{} {} (albedo {:.3f})", name, channel[c], media[c].reduced_albedo());
      const profile::MonteCarloProfile truth(profile::scene_of(media[c]), options);
      row(what, "dipole", profile::Dipole(media[c]), truth);
      row(what, "better dipole", profile::BetterDipole(media[c]), truth);
      row(what, "photon beam", profile::PhotonBeam(media[c]), truth);
    }
  }

  const struct {
    const char* name;
    SpectralSkin skin;
  } skins[] = {{"Caucasian", {.melanin = .005, .blend = .7, .haemoglobin = .005}},
               {"Asian", {.melanin = .15, .blend = 0, .haemoglobin = .01}},
               {"African", {.melanin = .5, .blend = .7, .haemoglobin = .05}}};

  for (const auto& one : skins)
    for (const double nm : {450.0, 550.0, 650.0}) {
      const auto layers = optics::skin_layers(one.skin, nm);
      const profile::MonteCarloProfile truth(profile::scene_of(layers), options);
      row(fmt::format("{} of [DJ06], {} nm (albedo {:.3f})", one.name, nm,
                      layers[0].medium().reduced_albedo()),
          "multipole", profile::LayeredProfile(layers, profile::SlabProfile::Side::reflected), truth);
    }
}
