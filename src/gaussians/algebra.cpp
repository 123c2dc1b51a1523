// SPDX-License-Identifier: MIT
#include "gaussians/algebra.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <numbers>

#include "core/assert.h"
#include "profile/slab.h"

namespace dermis::gaussians {
namespace {

using Sum = std::vector<Term>;
constexpr int merged_per_decade = 32;
constexpr std::size_t most_terms = 512;

void add_to(Sum& sum, const Sum& more) { sum.insert(sum.end(), more.begin(), more.end()); }

/// One of the seven spectra of a layer as a profile, fitted in Hankel space.
class Spectrum final : public profile::RadialProfile {
 public:
  using Part = double (*)(const profile::Spectra&);
  Spectrum(const profile::Multipole& slab, Part part) : slab_(slab), part_(part) {}

  double at(double radius_mm) const override { return profile::inverse_hankel(*this, radius_mm); }
  double hankel(double k_per_mm) const override { return part_(slab_.spectra(k_per_mm)); }
  bool hankel_is_exact() const override { return true; }
  double inner_mm() const override { return slab_.inner_mm(); }
  double outer_mm() const override { return slab_.outer_mm(); }
  std::string name() const override { return "multipole"; }

 private:
  const profile::Multipole& slab_;
  Part part_;
};

Sum fit_part(const profile::Multipole& slab, Spectrum::Part part, int terms) {
  const Spectrum spectrum(slab, part);
  if (spectrum.total() <= 1e-12) return {};  // black, or too thick to let anything through
  Sum fitted = fit_channel(spectrum, terms, Weights::any_sign).terms;
  // Scales the weights to the exact total. The fit minimises the residual and may miss the total, but no
  // light may get lost from layer to layer.
  const double scale = spectrum.total() / total(fitted);
  for (Term& term : fitted) term.weight *= scale;
  return fitted;
}

}  // namespace

std::vector<Term> convolve(std::span<const Term> f, std::span<const Term> g) {
  Sum product;
  product.reserve(f.size() * g.size());
  for (const Term& a : f)
    for (const Term& b : g) product.push_back({a.variance_mm2 + b.variance_mm2, a.weight * b.weight});
  if (product.size() > most_terms) return merge(product);
  std::sort(product.begin(), product.end(),
            [](const Term& a, const Term& b) { return a.variance_mm2 < b.variance_mm2; });
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

double edge_response(std::span<const Term> terms, double x_mm) {
  double sum = 0;
  for (const Term& term : terms) sum += term.weight * std::erfc(x_mm / std::sqrt(2 * term.variance_mm2)) / 2;
  return sum;
}

double difference_percent(std::span<const Term> sum, std::span<const Term> other) {
  using std::numbers::pi;
  const auto product = [](std::span<const Term> a, std::span<const Term> b) {
    double value = 0;
    for (const Term& s : a)
      for (const Term& t : b)
        value += s.weight * t.weight / (4 * pi * pi * (s.variance_mm2 + t.variance_mm2));
    return value;
  };
  const double own = product(sum, sum);
  return 100 * std::sqrt(std::max(0.0, own - 2 * product(sum, other) + product(other, other)) / own);
}

std::vector<Term> merge(std::span<const Term> terms) {
  double straight = 0;
  std::map<int, double> grid;
  const auto variance_at = [](int node) {
    return std::pow(10.0, static_cast<double>(node) / merged_per_decade);
  };

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
  using profile::Spectra;
  const profile::Multipole slab(layer, eta_above, eta_below);
  const auto fit = [&](Spectrum::Part part) { return fit_part(slab, part, terms); };

  LayerSums sums;
  sums.reflect_above = fit([](const Spectra& s) { return s.reflect_above; });
  if (std::isfinite(layer.thickness_mm)) {
    sums.transmit_above = fit([](const Spectra& s) { return s.transmit_above; });
    sums.reflect_below = fit([](const Spectra& s) { return s.reflect_below; });
    sums.transmit_below = fit([](const Spectra& s) { return s.transmit_below; });
  }

  if (!slab.thin()) {  // a beam acts like diffuse light
    sums.beam_reflect = sums.reflect_above;
    sums.beam_transmit = sums.transmit_above;
    return sums;
  }

  sums.beam_reflect = fit([](const Spectra& s) { return s.beam.reflect; });
  sums.beam_transmit = fit([](const Spectra& s) { return s.beam.transmit; });
  sums.beam_straight = fit([](const Spectra& s) { return s.beam.straight; });
  return sums;
}

Stacked stack(const LayerSums& upper, const LayerSums& lower, double energy) {
  DERMIS_ASSERT(energy > 0 && energy < 1);
  // Sum_m (R1' R2)^m, the bounces between the two layers.
  const Sum bounce = convolve(upper.reflect_below, lower.reflect_above);
  const double kept = total(bounce);
  DERMIS_ASSERT(kept < 1);

  // Adds bounces until the rest of the geometric series of their totals is at most `energy`.
  Sum series{{0, 1}}, power{{0, 1}};
  double rest = kept / (1 - kept);
  while (rest > energy) {
    power = convolve(power, bounce);
    add_to(series, power);
    rest *= kept;
  }
  series = merge(series);

  const auto sum = [](Sum a, const Sum& b, double sign = 1) {
    for (const Term& term : b) a.push_back({term.variance_mm2, sign * term.weight});
    return merge(a);
  };
  const auto bounced = [&](const Sum& a, const Sum& b) { return merge(convolve(convolve(a, b), series)); };

  // Names as in profile::add.
  const Sum turned = sum(upper.beam_transmit, upper.beam_straight, -1);
  const Sum up = merge(convolve(
      sum(convolve(upper.beam_straight, lower.beam_reflect), convolve(lower.reflect_above, turned)), series));

  Stacked out;
  out.layer.reflect_above =
      sum(upper.reflect_above,
          convolve(bounced(upper.transmit_above, lower.reflect_above), upper.transmit_below));
  out.layer.transmit_above = bounced(upper.transmit_above, lower.transmit_above);
  out.layer.reflect_below =
      sum(lower.reflect_below,
          convolve(bounced(lower.transmit_below, upper.reflect_below), lower.transmit_above));
  out.layer.transmit_below = bounced(lower.transmit_below, upper.transmit_below);
  out.layer.beam_reflect = sum(upper.beam_reflect, convolve(upper.transmit_below, up));
  out.layer.beam_transmit =
      sum(convolve(upper.beam_straight, lower.beam_transmit),
          convolve(lower.transmit_above, sum(turned, convolve(upper.reflect_below, up))));
  out.layer.beam_straight = convolve(upper.beam_straight, lower.beam_straight);
  out.lost = rest;
  return out;
}

}  // namespace dermis::gaussians
