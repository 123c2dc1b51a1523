// SPDX-License-Identifier: MIT
#include "gaussians/algebra.h"

#include <algorithm>
#include <cmath>
#include <map>

#include "core/assert.h"
#include "profile/slab.h"

namespace dermis::gaussians {
namespace {

using Sum = std::vector<Term>;
constexpr int merged_per_decade = 32;
constexpr std::size_t most_terms = 512;

void add_to(Sum& sum, const Sum& more) { sum.insert(sum.end(), more.begin(), more.end()); }

Sum fit_side(const optics::Layer& layer, profile::SlabProfile::Side side, double eta_lit, double eta_other, int terms) {
  const profile::SlabProfile slab(layer, side, eta_lit, eta_other);
  Sum sum;
  const bool transmitted = side == profile::SlabProfile::Side::transmitted;
  const double straight = transmitted ? profile::Multipole(layer, eta_lit, eta_other).straight() : 0;
  if (straight > 0) sum.push_back({0, straight});
  if (slab.total() <= 1e-12) return sum;  // black, or too thick to let anything through
  Sum fitted = fit_channel(slab, terms, Weights::any_sign).terms;
  // The fit minimises the residual, not the lost total; light must not get lost from layer to layer, so the weights are scaled to it.
  const double scale = slab.total() / total(fitted);
  for (Term& term : fitted) term.weight *= scale;
  add_to(sum, fitted);
  return sum;
}

}  // namespace

std::vector<Term> convolve(std::span<const Term> f, std::span<const Term> g) {
  Sum product;
  product.reserve(f.size() * g.size());
  for (const Term& a : f)
    for (const Term& b : g) product.push_back({a.variance_mm2 + b.variance_mm2, a.weight * b.weight});
  if (product.size() > most_terms) return merge(product);
  std::sort(product.begin(), product.end(), [](const Term& a, const Term& b) { return a.variance_mm2 < b.variance_mm2; });
  return product;
}

double total(std::span<const Term> terms) {
  double sum = 0;
  for (const Term& term : terms) sum += term.weight;
  return sum;
}

double transform(std::span<const Term> terms, double k_per_mm) {
  double sum = 0;
  for (const Term& term : terms) sum += term.weight * std::exp(-term.variance_mm2 * k_per_mm * k_per_mm / 2);
  return sum;
}

std::vector<Term> merge(std::span<const Term> terms) {
  double straight = 0;
  std::map<int, double> grid;
  const auto variance_at = [](int node) { return std::pow(10.0, static_cast<double>(node) / merged_per_decade); };
  for (const Term& term : terms) {
    if (term.variance_mm2 <= 0) {
      straight += term.weight;
      continue;
    }
    const int node = static_cast<int>(std::floor(std::log10(term.variance_mm2) * merged_per_decade));
    const double low = variance_at(node), high = variance_at(node + 1);
    const double part = (term.variance_mm2 - low) / (high - low);
    grid[node] += term.weight * (1 - part);
    grid[node + 1] += term.weight * part;
  }
  Sum merged;
  if (straight != 0) merged.push_back({0, straight});
  for (const auto& [node, weight] : grid)
    if (weight != 0) merged.push_back({variance_at(node), weight});
  return merged;
}

LayerSums fit_layer(const optics::Layer& layer, double eta_above, double eta_below, int terms) {
  using Side = profile::SlabProfile::Side;
  LayerSums sums;
  sums.reflect_above = fit_side(layer, Side::reflected, eta_above, eta_below, terms);
  if (!std::isfinite(layer.thickness_mm)) return sums;
  sums.transmit_above = fit_side(layer, Side::transmitted, eta_above, eta_below, terms);
  sums.reflect_below = fit_side(layer, Side::reflected, eta_below, eta_above, terms);
  sums.transmit_below = fit_side(layer, Side::transmitted, eta_below, eta_above, terms);
  return sums;
}

Stacked stack(const LayerSums& upper, const LayerSums& lower, double energy) {
  DERMIS_ASSERT(energy > 0 && energy < 1);
  // Sum_m (R1' R2)^m, the light that bounces between the two
  const Sum bounce = convolve(upper.reflect_below, lower.reflect_above);
  const double kept = total(bounce);
  DERMIS_ASSERT(kept < 1);
  Sum series{{0, 1}}, power{{0, 1}};
  double rest = kept / (1 - kept);
  while (rest > energy) {
    power = convolve(power, bounce);
    add_to(series, power);
    rest *= kept;
  }
  series = merge(series);
  const auto product = [&](const Sum& a, const Sum& b, const Sum& c) { return merge(convolve(convolve(convolve(a, b), c), series)); };
  const Sum one{{0, 1}};
  Stacked out;
  out.layer.reflect_above = upper.reflect_above;
  add_to(out.layer.reflect_above, product(upper.transmit_above, lower.reflect_above, upper.transmit_below));
  out.layer.reflect_above = merge(out.layer.reflect_above);
  out.layer.transmit_above = product(upper.transmit_above, lower.transmit_above, one);
  out.layer.reflect_below = lower.reflect_below;
  add_to(out.layer.reflect_below, product(lower.transmit_below, upper.reflect_below, lower.transmit_above));
  out.layer.reflect_below = merge(out.layer.reflect_below);
  out.layer.transmit_below = product(lower.transmit_below, upper.transmit_below, one);
  out.lost = rest;
  return out;
}

}  // namespace dermis::gaussians
