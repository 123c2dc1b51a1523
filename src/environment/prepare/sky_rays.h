// SPDX-License-Identifier: MIT
// Sums up which rays around a point of the skin reach the sky, in harmonics. All in float, sixteen rays side
// by side, because this is most of the work of a bake.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <glm/glm.hpp>
#include <vector>

#include "environment/harmonics.h"

namespace dermis::environment {

inline constexpr std::size_t ray_lanes = 16;

/// Real spherical harmonics (harmonics.h) of sixteen unit directions.
struct DirectionLanes {
  std::array<float, ray_lanes> x{}, y{}, z{};
};
using HarmonicLanes = std::array<std::array<float, ray_lanes>, harmonic_terms>;
void harmonics_of(const DirectionLanes& directions, HarmonicLanes& out);

/// Cosine-weighted directions around +z, the same for every point. Each point turns them by its own angle and
/// shifts their polar angles, so that the noise has no pattern.
class RaySet {
 public:
  explicit RaySet(int rays);
  int size() const { return static_cast<int>(cosine_.size()); }

  /// The shift of a point, made from two numbers in 0..1: for polar angles, and cosine and sine of the
  /// azimuth.
  struct Shift {
    float polar = 0, cosine = 1, sine = 0;
  };
  static Shift shift_of(glm::dvec2 shift);
  glm::vec3 direction(int i, const Shift& shift) const {
    const auto at = static_cast<std::size_t>(i);
    float r2 = share_[at] + shift.polar;
    r2 -= r2 >= 1 ? 1.0f : 0.0f;
    const float r = std::sqrt(r2);
    return {r * (cosine_[at] * shift.cosine - sine_[at] * shift.sine),
            r * (sine_[at] * shift.cosine + cosine_[at] * shift.sine), std::sqrt(std::max(1 - r2, 0.0f))};
  }

 private:
  std::vector<float> share_, cosine_, sine_;
};

/// Sums over the directions of the rays and over those that reach the sky. Computes harmonics at the end, and
/// only if something occludes: much of a head sees the whole sky.
class SkySums {
 public:
  void add(const glm::vec3& direction, bool unoccluded);
  int ray_count() const { return static_cast<int>(reaches_sky_.size()); }
  int unoccluded_count() const { return unoccluded_; }
  const glm::dvec3& all() const { return all_; }    ///< sum of directions
  const glm::dvec3& open() const { return open_; }  ///< sum of directions that reach the sky
  /// Sums the harmonics of all directions, and of those that reach the sky.
  void harmonics(Harmonics& all, Harmonics& open) const;

 private:
  std::vector<DirectionLanes> directions_;
  std::vector<float> reaches_sky_;  ///< 1 or 0 for each
  glm::dvec3 all_{0}, open_{0};
  int unoccluded_ = 0;
};

}  // namespace dermis::environment
