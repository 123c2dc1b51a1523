// SPDX-License-Identifier: MIT
// Monte-Carlo: photons followed through layers. Slow and noisy, but without the approximations of diffusion:
// used for dark skin, and as the reference for all other models.
// Based on:
// [WJZ95] Wang, Jacques, Zheng: MCML - Monte Carlo modeling of light transport in multi-layered tissues.
//         CMPB 47, 1995
#pragma once

#include <cstdint>
#include <filesystem>
#include <memory>
#include <string>
#include <vector>

#include "dermis/profile.h"
#include "tissue/optics/layers.h"
#include "tissue/optics/media.h"
#include "tissue/profile/radial.h"

namespace dermis::profile {

struct MonteCarloOptions {
  std::uint64_t photons = ProfileOptions().photons;  ///< per channel, in the range of ProfileOptions
  std::uint64_t seed = ProfileOptions().seed;
  /// Folder in which results are kept; empty: only in memory. A damaged entry is computed again.
  std::filesystem::path cache;
};

/// A layer for photons: true scattering with a Henyey-Greenstein phase function, per mm.
struct ScatterLayer {
  optics::Medium medium;
  double thickness_mm = 0;  ///< > 0; infinite only for the last
};

/// The layers from above, with air (index 1) on both sides. Every index step reflects by Fresnel, also
/// between layers.
struct ScatterScene {
  std::vector<ScatterLayer> layers;
  /// a perpendicular pencil beam, or diffuse light into one point
  enum class Light { perpendicular, diffuse } light = Light::perpendicular;
};

/// Returns a half-space of the medium (sigma_t > 0, passes optics::check) under a perpendicular beam, with
/// its true sigma_s and g.
ScatterScene scene_of(const optics::Medium& medium);
/// Returns the layers with their reduced scattering as isotropic scattering (similarity: g = 0, [JMLH01] sec.
/// 2) under a perpendicular beam.
ScatterScene scene_of(const optics::Layers& layers);

/// Energies as fractions of the flux that entered (multiply by 1 - F for fractions of the incident flux).
struct MonteCarloResult {
  /// By distance from the point of entry, 16 rings per decade. reflected: all light that leaves upwards,
  /// including light that only a lower boundary has reflected. transmitted: light that leaves downwards after
  /// at least one scattering.
  Annuli reflected, transmitted;
  std::vector<double> reflected_error;                        ///< standard error of each ring's energy
  double reflected_total = 0, reflected_total_error = 0;      ///< with standard error
  double transmitted_total = 0, transmitted_total_error = 0;  ///< scattered light only
  double ballistic = 0;                                       ///< transmitted without any scattering
  std::vector<double> absorbed;                               ///< per layer, including `cut`
  /// carried by photons that were ended after 200,000 scatterings
  double cut = 0;
  /// Integrals over r from the radius that holds 5 % of the light; further in, noise averages out in a fit.
  struct Squares {
    double signal_per_mm2 = 0, error_per_mm2 = 0;
  };
  Squares squares() const;
  /// Returns the noise as a fit sees it: 100 sqrt( Int r error^2 dr / Int r R^2 dr ).
  double noise_percent() const;
};

/// Traces options.photons photons in 64 batches that all cores share. Each photon has its own counter-based
/// random numbers, so that equal options give equal bits on any number of threads. Absorption reduces
/// weights, outer boundaries split the weight, weights below 1e-3 play roulette [WJZ95 sec. 3]. A photon ends
/// after 200,000 scatterings, which matters only without absorption (0.5 % of the light). Results are kept in
/// memory (the last 64) and in options.cache. Counts steps (base/core/hooks.h).
/// Throws InputError for values out of range, Cancelled if its caller ends it.
std::shared_ptr<const MonteCarloResult> monte_carlo(const ScatterScene& scene,
                                                    const MonteCarloOptions& options);

/// Reflected light as a profile. R is interpolated linearly in log-log between ring centres; total, quantiles
/// and R^ come from the rings themselves.
class MonteCarloProfile final : public RadialProfile {
 public:
  /// Traces photons or takes a kept result, as monte_carlo() does and with its errors.
  MonteCarloProfile(const ScatterScene& scene, const MonteCarloOptions& options);

  double at(double radius_mm) const override;
  /// Of the rings beside r, whose errors are taken as independent.
  double standard_error_at(double radius_mm) const override;
  double hankel(double k_per_mm) const override { return result_->reflected.hankel(k_per_mm); }
  double total() const override { return result_->reflected.total(); }
  double within(double radius_mm) const override { return result_->reflected.within(radius_mm); }
  double quantile(double p) const override { return result_->reflected.quantile(p); }
  double inner_mm() const override { return inner_mm_; }
  double outer_mm() const override { return result_->reflected.edges_mm().back() / 45; }
  bool has_pole() const override { return true; }
  std::string name() const override { return "Monte-Carlo"; }
  /// All that was counted: errors, transmitted and absorbed light.
  const MonteCarloResult& result() const { return *result_; }

 private:
  /// The rings between whose centres a radius lies, and how far it is on the way in log r. Both are the same
  /// ring in the middle of the first and past the middle of the last.
  struct Between {
    std::size_t below = 0, above = 0;
    double part = 0;
  };
  Between between(double radius_mm) const;
  double centre_mm(std::size_t ring) const;  ///< for rings 1 and up: ring 0 has no centre in log r

  std::shared_ptr<const MonteCarloResult> result_;
  double inner_mm_;
};

}  // namespace dermis::profile
