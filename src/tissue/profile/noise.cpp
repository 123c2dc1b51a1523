// SPDX-License-Identifier: MIT
#include "tissue/profile/noise.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "tissue/profile/monte_carlo.h"
#include "tissue/profile/spectral.h"

namespace dermis::profile {
namespace {

/// Returns 2 pi Int r R^2 dr from the radius that holds 5 % of the light, by the midpoint rule in log r.
double signal_per_mm2(const RadialProfile& profile) {
  constexpr int steps = 400;
  const double start = profile.quantile(0.05), step = std::log(60 * profile.outer_mm() / start) / steps;
  double sum = 0;
  for (int i = 0; i < steps; ++i) {
    const double r = start * std::exp((i + 0.5) * step), value = profile.at(r);
    sum += 2 * std::numbers::pi * r * r * value * value * step;
  }
  return sum;
}

}  // namespace

std::optional<Sampled> sampled(const RadialProfile& profile) {
  if (const auto* one = dynamic_cast<const MonteCarloProfile*>(&profile))
    return Sampled{.noise_percent = one->result().noise_percent(), .cut = one->result().cut};

  const auto* mixed = dynamic_cast<const WeightedProfile*>(&profile);
  if (mixed == nullptr) return std::nullopt;

  // Errors of the wavelengths are independent, so their squares add up with the squares of the weights.
  Sampled all;
  double error_per_mm2 = 0;
  for (const WeightedProfile::Part& part : mixed->parts()) {
    const auto* one = dynamic_cast<const MonteCarloProfile*>(part.profile.get());
    if (one == nullptr) return std::nullopt;
    error_per_mm2 += part.weight * part.weight * one->result().squares().error_per_mm2;
    all.cut = std::max(all.cut, one->result().cut);
  }
  all.noise_percent = 100 * std::sqrt(error_per_mm2 / signal_per_mm2(profile));
  return all;
}

}  // namespace dermis::profile
