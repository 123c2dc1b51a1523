// SPDX-License-Identifier: MIT
// One photon's path through the layers; the inner loop of tissue/profile/monte_carlo.h.
#pragma once

#include <cmath>
#include <cstdint>
#include <vector>

#include "tissue/profile/monte_carlo.h"

namespace dermis::profile {

/// Counter-based random numbers: number n of photon p depends only on (seed, p, n), so that results do not
/// depend on threads. The mixer is splitmix64 (Steele, Lea, Flood: Fast Splittable Pseudorandom Number
/// Generators. OOPSLA 2014).
class PhotonRandom {
 public:
  PhotonRandom(std::uint64_t seed, std::uint64_t photon)
      : state_(mix(mix(seed) ^ mix(photon + 0x632BE59BD9B4E019u))) {}
  /// Returns a number in (0, 1), both ends excluded.
  double next() {
    state_ += 0x9E3779B97F4A7C15u;
    return (static_cast<double>(mix(state_) >> 11) + 0.5) * 0x1p-53;
  }

 private:
  static std::uint64_t mix(std::uint64_t x) {
    x = (x ^ (x >> 30)) * 0xBF58476D1CE4E5B9u;
    x = (x ^ (x >> 27)) * 0x94D049BB133111EBu;
    return x ^ (x >> 31);
  }
  std::uint64_t state_;
};

/// A layer with the values that the loop needs.
struct PhotonLayer {
  double top_mm, bottom_mm;
  double sigma_t_per_mm, albedo, g, eta;
};

/// Counts a batch of photons; one per batch, so that no locks are needed.
struct PhotonTally {
  explicit PhotonTally(const std::vector<double>& edges_mm, std::size_t layers);
  /// Adds weight (a fraction of a photon) to the ring that holds the distance sqrt(radius2_mm2) >= 0;
  /// distances past the last edge count in the last ring.
  void add(std::vector<double>& rings, double radius2_mm2, double weight) const;

  double log_inner, rings_per_log;  // map log of radius^2 to ring
  std::vector<double> reflected, transmitted, absorbed;
  bool leave_single_out = false;  // skips the light that single_rings() computes
  double reflected_sum = 0, reflected_sum2 = 0, transmitted_sum = 0, transmitted_sum2 = 0, ballistic = 0,
         cut = 0;
};

/// Traces photon number `photon` and counts it.
void trace_photon(const std::vector<PhotonLayer>& layers, ScatterScene::Light light, PhotonRandom random,
                  PhotonTally& tally);

}  // namespace dermis::profile
