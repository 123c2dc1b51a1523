// SPDX-License-Identifier: MIT
#include "environment/prepare/sky_rays.h"

#include <cmath>
#include <cstdlib>
#include <numbers>

#include "environment/radical_inverse.h"

namespace dermis::environment {
namespace {

std::array<float, harmonic_terms> make_lane_norms() {
  std::array<float, harmonic_terms> made{};
  for (int l = 0; l <= harmonic_order; ++l)
    for (int m = -l; m <= l; ++m)
      made[harmonic_number(l, m)] = static_cast<float>(harmonic_norm(l, std::abs(m)));
  return made;
}
const std::array<float, harmonic_terms> lane_norms = make_lane_norms();

}  // namespace

// The recurrences of harmonics(), each step for all lanes.
void harmonics_of(const DirectionLanes& d, HarmonicLanes& out) {
  std::array<float, ray_lanes> cosine, sine{};
  cosine.fill(1);
  float diagonal = 1;  // 1 3 5 ... (2 m - 1)

  for (int m = 0; m <= harmonic_order; ++m) {
    std::array<float, ray_lanes> before{}, here;
    here.fill(diagonal);
    for (int l = m; l <= harmonic_order; ++l) {
      const float norm = lane_norms[harmonic_number(l, m)];
      std::array<float, ray_lanes>&positive = out[harmonic_number(l, m)],
                        &negative = out[harmonic_number(l, -m)];
      const float a = static_cast<float>(2 * l + 1) / static_cast<float>(l - m + 1),
                  b = static_cast<float>(l + m) / static_cast<float>(l - m + 1);

      for (std::size_t j = 0; j < ray_lanes; ++j) {
        const float value = norm * here[j];
        negative[j] = value * sine[j];
        positive[j] = value * cosine[j];  // for m = 0 both are the same entry
        const float next = a * d.y[j] * here[j] - b * before[j];
        before[j] = here[j];
        here[j] = next;
      }
    }

    // Next m: sin^m(polar) times cosine and sine of m azimuths.
    diagonal *= static_cast<float>(2 * m + 1);
    for (std::size_t j = 0; j < ray_lanes; ++j) {
      const float turned = cosine[j] * d.z[j] - sine[j] * d.x[j];
      sine[j] = cosine[j] * d.x[j] + sine[j] * d.z[j];
      cosine[j] = turned;
    }
  }
}

RaySet::RaySet(int rays) {
  for (int i = 0; i < rays; ++i) {
    const double azimuth = 2 * std::numbers::pi * radical_inverse(static_cast<unsigned>(i));
    share_.push_back(static_cast<float>((i + 0.5) / rays));
    cosine_.push_back(static_cast<float>(std::cos(azimuth)));
    sine_.push_back(static_cast<float>(std::sin(azimuth)));
  }
}

RaySet::Shift RaySet::shift_of(glm::dvec2 shift) {
  const double azimuth = 2 * std::numbers::pi * shift.y;
  return {.polar = static_cast<float>(shift.x),
          .cosine = static_cast<float>(std::cos(azimuth)),
          .sine = static_cast<float>(std::sin(azimuth))};
}

void SkySums::add(const glm::vec3& direction, bool unoccluded) {
  const std::size_t lane = reaches_sky_.size() % ray_lanes;
  if (lane == 0) directions_.emplace_back();
  directions_.back().x[lane] = direction.x;
  directions_.back().y[lane] = direction.y;
  directions_.back().z[lane] = direction.z;
  reaches_sky_.push_back(unoccluded ? 1.0f : 0.0f);
  all_ += glm::dvec3(direction);
  if (!unoccluded) return;
  ++unoccluded_;
  open_ += glm::dvec3(direction);
}

void SkySums::harmonics(Harmonics& all, Harmonics& open) const {
  HarmonicLanes all_sums{}, open_sums{};
  for (std::size_t block = 0; block < directions_.size(); ++block) {
    HarmonicLanes values;
    harmonics_of(directions_[block], values);

    // Lanes of the last block without a direction have weight 0.
    std::array<float, ray_lanes> used{}, unoccluded{};
    for (std::size_t j = 0; j < ray_lanes && block * ray_lanes + j < reaches_sky_.size(); ++j) {
      used[j] = 1;
      unoccluded[j] = reaches_sky_[block * ray_lanes + j];
    }

    for (std::size_t k = 0; k < harmonic_terms; ++k)
      for (std::size_t j = 0; j < ray_lanes; ++j) {
        all_sums[k][j] += used[j] * values[k][j];
        open_sums[k][j] += unoccluded[j] * values[k][j];
      }
  }

  for (std::size_t k = 0; k < harmonic_terms; ++k) {
    all[k] = open[k] = 0;
    for (std::size_t j = 0; j < ray_lanes; ++j) {
      all[k] += static_cast<double>(all_sums[k][j]);
      open[k] += static_cast<double>(open_sums[k][j]);
    }
  }
}

}  // namespace dermis::environment
