// SPDX-License-Identifier: MIT
// Monte-Carlo: photons followed through layers. Slow, noisy and right: the model for dark skin and the judge
// of all others. Based on: [WJZ95] Wang, Jacques, Zheng: MCML - Monte Carlo modeling of light transport in
// multi-layered tissues. CMPB 47, 1995
#pragma once

#include <cstdint>
#include <filesystem>
#include <functional>
#include <memory>
#include <string>
#include <vector>

#include "optics/layers.h"
#include "optics/media.h"
#include "profile/radial.h"

namespace dermis::profile {

struct MonteCarloOptions {
  std::uint64_t photons = 500'000;  ///< 1,000 to 1e9 a channel
  std::uint64_t seed = 1;
  /// a folder in which results are kept; empty: only in memory. A damaged entry is made again.
  std::filesystem::path cache;
  /// How much of a run is done, above 0 to 1: called after each of its batches, from one thread at a time;
  /// once, with 1, if the result was kept. It must not throw, and has no part in the result.
  std::function<void(double)> progress = {};
};

/// InputError, place `where`, if photons is out of range.
void check_photons(std::uint64_t photons, const std::string& where);

/// One layer as photons see it: true scattering with a Henyey-Greenstein phase function, per mm.
struct ScatterLayer {
  optics::Medium medium;
  double thickness_mm = 0;  ///< > 0; infinite only for the last
};

/// What light meets, from above; air (index 1) on both sides. Each index step, also between layers, reflects
/// by Fresnel.
struct ScatterScene {
  std::vector<ScatterLayer> layers;
  /// a pencil beam, or light from everywhere into one point
  enum class Light { perpendicular, diffuse } light = Light::perpendicular;
};

/// A half-space of the medium (ranges as optics::check wants them, sigma_t > 0) under a perpendicular beam;
/// its true sigma_s and g.
ScatterScene scene_of(const optics::Medium& medium);
/// Reduced scattering as isotropic scattering (similarity: g = 0, [JMLH01] sec. 2) under a perpendicular
/// beam.
ScatterScene scene_of(const optics::Layers& layers);

/// Everything as a part of the flux that entered (multiply by 1 - F for what was sent).
struct MonteCarloResult {
  /// By distance from where it entered, 16 rings a decade. reflected: all that leaves upwards, also what only
  /// a boundary below has turned; transmitted: what leaves downwards after a scattering at least.
  Annuli reflected, transmitted;
  std::vector<double> reflected_error;                        ///< standard error of each ring's energy
  double reflected_total = 0, reflected_total_error = 0;      ///< with standard error
  double transmitted_total = 0, transmitted_total_error = 0;  ///< scattered light only
  double ballistic = 0;                                       ///< transmitted without a scattering
  std::vector<double> absorbed;                               ///< by layer, with what was cut
  /// still on its way after 200,000 scatterings, and given up
  double cut = 0;
  /// 2 pi Int r R^2 dr and the same of R's standard error [1/mm^2], from the radius of 5 % of the light on:
  /// what is inside, fits even out.
  struct Squares {
    double signal_per_mm2 = 0, error_per_mm2 = 0;
  };
  Squares squares() const;
  /// Noise as the fits see it: 100 sqrt( Int r error^2 dr / Int r R^2 dr ).
  double noise_percent() const;
};

/// Follows options.photons photons, in 64 batches that all cores share. Each photon has its own counter-based
/// random numbers, so equal options give equal bits on any number of threads. Weights instead of absorption,
/// splitting instead of chance at the outer boundaries, roulette under 1e-3 [WJZ95 sec. 3]. A photon ends
/// after 200,000 scatterings (only without absorption does it matter: 0.5 % of the light). Results are kept
/// in memory (the last 64) and in options.cache. InputError: values out of range, photons out of range.
std::shared_ptr<const MonteCarloResult> monte_carlo(const ScatterScene& scene,
                                                    const MonteCarloOptions& options);

/// Reflected light as a profile: R between ring centres by straight lines in log-log; total, quantiles and R^
/// from the rings themselves.
class MonteCarloProfile final : public RadialProfile {
 public:
  /// Follows the photons, or takes a kept result, as monte_carlo() does and with its errors.
  MonteCarloProfile(const ScatterScene& scene, const MonteCarloOptions& options);

  double at(double radius_mm) const override;
  double hankel(double k_per_mm) const override { return result_->reflected.hankel(k_per_mm); }
  double total() const override { return result_->reflected.total(); }
  double within(double radius_mm) const override { return result_->reflected.within(radius_mm); }
  double quantile(double p) const override { return result_->reflected.quantile(p); }
  double inner_mm() const override { return inner_mm_; }
  double outer_mm() const override { return result_->reflected.edges_mm().back() / 45; }
  bool has_pole() const override { return true; }
  std::string name() const override { return "Monte-Carlo"; }
  /// Everything else that the photons told: errors, transmitted and absorbed light.
  const MonteCarloResult& result() const { return *result_; }

 private:
  std::shared_ptr<const MonteCarloResult> result_;
  double inner_mm_;
};

}  // namespace dermis::profile
