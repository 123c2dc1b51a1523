// SPDX-License-Identifier: MIT
#include "tissue/profile/monte_carlo.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

#include "base/core/error.h"
#include "base/core/hooks.h"
#include "base/core/parallel.h"
#include "base/settings/check.h"
#include "base/settings/profile_fields.h"
#include "tissue/profile/monte_carlo_cache.h"
#include "tissue/profile/photon.h"
#include "tissue/profile/single_rings.h"

namespace dermis::profile {
namespace {

using std::numbers::pi;
constexpr std::size_t batches = 64;
constexpr int rings_per_decade = 16;

void check(const ScatterScene& scene, const MonteCarloOptions& options) {
  check_member(&ProfileOptions::photons, static_cast<double>(options.photons));
  if (scene.layers.empty() || scene.layers.size() > optics::max_layers)
    throw input_error("monte-carlo", "1 to {} layers", optics::max_layers);
  for (std::size_t i = 0; i < scene.layers.size(); ++i) {
    const std::string place = "monte-carlo: layer " + std::to_string(i);
    optics::check(scene.layers[i].medium, place);
    const double thickness = scene.layers[i].thickness_mm;
    if (!(thickness > 0) || (!std::isfinite(thickness) && i + 1 < scene.layers.size()))
      throw input_error(place, "thickness {} mm", thickness);
  }
}

std::vector<PhotonLayer> prepare(const ScatterScene& scene) {
  std::vector<PhotonLayer> layers;
  double top = 0;
  for (const ScatterLayer& layer : scene.layers) {
    const optics::Medium& medium = layer.medium;
    layers.push_back({top, top + layer.thickness_mm, medium.sigma_t_per_mm(),
                      medium.sigma_s_per_mm / medium.sigma_t_per_mm(), medium.g, medium.eta});
    top += layer.thickness_mm;
  }
  return layers;
}

/// Returns rings from a thousandth of the shortest mean free path to where no light returns.
std::vector<double> edges_of(const ScatterScene& scene) {
  double shortest = HUGE_VAL, longest = 0;
  for (const ScatterLayer& layer : scene.layers) {
    const double free = layer.medium.mean_free_path().mm;
    shortest = std::min({shortest, free, 1 / layer.medium.sigma_t_per_mm()});
    longest = std::max(longest,
                       std::min(30 * std::max(free, layer.medium.diffuse_mean_free_path().mm), 3000 * free));
  }
  return log_edges(1e-3 * shortest, std::max(longest, 30 * shortest), rings_per_decade);
}

double standard_error(double sum, double sum2, double count) {
  const double mean = sum / count;
  return std::sqrt(std::max(0.0, sum2 / count - mean * mean) / count);
}

MonteCarloResult gather(const std::vector<PhotonTally>& tallies, const std::vector<double>& edges,
                        double photons, const std::vector<double>& exact) {
  MonteCarloResult result;
  const std::size_t rings = edges.size() - 1;
  std::vector<double> reflected(rings), transmitted(rings), reflected2(rings);
  double r = 0, r2 = 0, t = 0, t2 = 0;
  result.absorbed.assign(tallies[0].absorbed.size(), 0.0);

  for (const PhotonTally& tally : tallies) {
    for (std::size_t i = 0; i < rings; ++i) {
      reflected[i] += tally.reflected[i] / photons;
      transmitted[i] += tally.transmitted[i] / photons;
      reflected2[i] += tally.reflected[i] * tally.reflected[i];
    }
    for (std::size_t i = 0; i < result.absorbed.size(); ++i)
      result.absorbed[i] += tally.absorbed[i] / photons;
    r += tally.reflected_sum;
    r2 += tally.reflected_sum2;
    t += tally.transmitted_sum;
    t2 += tally.transmitted_sum2;
    result.ballistic += tally.ballistic / photons;
    result.cut += tally.cut / photons;
  }

  // Standard error of each ring from the spread of the batches.
  const double n = static_cast<double>(tallies.size());
  for (std::size_t i = 0; i < rings; ++i) {
    const double mean = reflected[i] * photons / n;
    result.reflected_error.push_back(std::sqrt(std::max(0.0, reflected2[i] - n * mean * mean) / (n - 1) * n) /
                                     photons);
  }

  // Adds the light scattered once where it is known exactly; the tallies have left it out.
  for (std::size_t i = 0; i < rings; ++i) {
    reflected[i] += exact[i];
    result.reflected_total += exact[i];
  }

  result.reflected_total += r / photons;
  result.reflected_total_error = standard_error(r, r2, photons);
  result.transmitted_total = t / photons;
  result.transmitted_total_error = standard_error(t, t2, photons);
  result.reflected = Annuli(edges, std::move(reflected));
  result.transmitted = Annuli(edges, std::move(transmitted));

  return result;
}

MonteCarloResult simulate(const ScatterScene& scene, const MonteCarloOptions& options) {
  const std::vector<PhotonLayer> layers = prepare(scene);
  const std::vector<double> edges = edges_of(scene);
  PhotonTally empty(edges, layers.size());
  empty.leave_single_out = single_is_exact(layers, scene.light);

  std::vector<PhotonTally> tallies(batches, empty);
  Steps steps("spread of light in skin", batches);
  parallel_for(batches, [&](std::size_t batch) {
    const std::uint64_t begin = options.photons * batch / batches,
                        end = options.photons * (batch + 1) / batches;
    PhotonTally tally = tallies[batch];  // a copy per thread: neighbours in memory would share cache lines
    for (std::uint64_t photon = begin; photon < end; ++photon)
      trace_photon(layers, scene.light, PhotonRandom(options.seed, photon), tally);
    tallies[batch] = std::move(tally);
    steps.done();
  });

  const auto exact =
      empty.leave_single_out ? single_rings(layers, edges) : std::vector<double>(edges.size() - 1, 0.0);
  return gather(tallies, edges, static_cast<double>(options.photons), exact);
}

}  // namespace

MonteCarloResult::Squares MonteCarloResult::squares() const {
  Squares squares;
  const auto& edges = reflected.edges_mm();
  const double start = reflected.quantile(0.05);
  for (std::size_t i = 1; i < reflected_error.size(); ++i) {
    if (edges[i] < start) continue;
    const double area = pi * (edges[i + 1] * edges[i + 1] - edges[i] * edges[i]);
    squares.error_per_mm2 += reflected_error[i] * reflected_error[i] / area;
    squares.signal_per_mm2 += reflected.energies()[i] * reflected.energies()[i] / area;
  }
  return squares;
}

double MonteCarloResult::noise_percent() const {
  const Squares s = squares();
  return s.signal_per_mm2 > 0 ? 100 * std::sqrt(s.error_per_mm2 / s.signal_per_mm2) : 0;
}

ScatterScene scene_of(const optics::Medium& medium) {
  return {.layers = {{medium, std::numeric_limits<double>::infinity()}}};
}

ScatterScene scene_of(const optics::Layers& layers) {
  ScatterScene scene;
  for (const optics::Layer& layer : layers) scene.layers.push_back({layer.medium(), layer.thickness_mm});
  return scene;
}

std::shared_ptr<const MonteCarloResult> monte_carlo(const ScatterScene& scene,
                                                    const MonteCarloOptions& options) {
  check(scene, options);
  const std::string key = cache_key(scene, options);
  if (auto found = cached(key, options.cache)) return found;
  auto result = std::make_shared<const MonteCarloResult>(simulate(scene, options));
  remember(key, options.cache, result);
  return result;
}

MonteCarloProfile::MonteCarloProfile(const ScatterScene& scene, const MonteCarloOptions& options)
    : result_(monte_carlo(scene, options)), inner_mm_(HUGE_VAL) {
  for (const ScatterLayer& layer : scene.layers)
    inner_mm_ = std::min(inner_mm_, layer.medium.mean_free_path().mm);
}

double MonteCarloProfile::centre_mm(std::size_t ring) const {
  const auto& edges = result_->reflected.edges_mm();
  return std::sqrt(edges[ring] * edges[ring + 1]);
}

MonteCarloProfile::Between MonteCarloProfile::between(double radius_mm) const {
  const auto& edges = result_->reflected.edges_mm();
  const std::size_t last = edges.size() - 2;
  if (radius_mm <= centre_mm(1)) return {1, 1, 0};
  std::size_t i =
      static_cast<std::size_t>(std::upper_bound(edges.begin(), edges.end(), radius_mm) - edges.begin()) - 1;
  if (radius_mm < centre_mm(i)) --i;
  if (i >= last) return {last, last, 0};
  return {i, i + 1, std::log(radius_mm / centre_mm(i)) / std::log(centre_mm(i + 1) / centre_mm(i))};
}

double MonteCarloProfile::at(double radius_mm) const {
  const Annuli& rings = result_->reflected;
  if (radius_mm >= rings.edges_mm().back()) return 0;

  // Light scattered once grows like 1/r.
  const double first_mm = centre_mm(1);
  if (radius_mm <= first_mm) return rings.density_per_mm2(1) * first_mm / std::max(radius_mm, 1e-300);

  // A straight line in log-log; linear where a ring is empty and has no logarithm.
  const Between b = between(radius_mm);
  const double below = rings.density_per_mm2(b.below), above = rings.density_per_mm2(b.above);
  if (b.below == b.above) return below;
  if (below <= 0 || above <= 0) return below + b.part * (above - below);
  return below * std::pow(above / below, b.part);
}

double MonteCarloProfile::standard_error_at(double radius_mm) const {
  const Annuli& rings = result_->reflected;
  const auto& edges = rings.edges_mm();
  if (radius_mm >= edges.back()) return 0;
  const auto error = [&](std::size_t ring) {
    return result_->reflected_error[ring] /
           (pi * (edges[ring + 1] * edges[ring + 1] - edges[ring] * edges[ring]));
  };

  const double first_mm = centre_mm(1);
  if (radius_mm <= first_mm) return error(1) * first_mm / std::max(radius_mm, 1e-300);

  // at() in both cases; its derivatives by the two rings are R (1 - t) / R_below and R t / R_above in
  // log-log.
  const Between b = between(radius_mm);
  if (b.below == b.above) return error(b.below);
  const double below = rings.density_per_mm2(b.below), above = rings.density_per_mm2(b.above);
  if (below <= 0 || above <= 0) return std::hypot((1 - b.part) * error(b.below), b.part * error(b.above));
  return at(radius_mm) * std::hypot((1 - b.part) * error(b.below) / below, b.part * error(b.above) / above);
}

}  // namespace dermis::profile
