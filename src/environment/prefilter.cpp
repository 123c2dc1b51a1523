// SPDX-License-Identifier: MIT
#include <algorithm>
#include <cmath>
#include <numbers>

#include "base/core/parallel.h"
#include "environment/environment.h"
#include "environment/radical_inverse.h"

namespace dermis::environment {
namespace {

using std::numbers::pi;
constexpr int lobe_samples = 192;

image::ImageF empty(int width, int height) {
  return {
      .width = width,
      .height = height,
      .channels = 3,
      .values = std::vector<float>(static_cast<std::size_t>(width) * static_cast<std::size_t>(height) * 3)};
}

// Returns the picture at another size: each pixel is the mean over its area; enlarges bilinearly.
image::ImageF resampled(const image::ImageF& from, int width, int height) {
  image::ImageF to = empty(width, height);
  const int nx = std::clamp((from.width + width - 1) / width, 1, 64),
            ny = std::clamp((from.height + height - 1) / height, 1, 64);
  parallel_for(static_cast<std::size_t>(height), [&](std::size_t y) {
    for (int x = 0; x < width; ++x) {
      glm::dvec3 sum(0);
      for (int j = 0; j < ny; ++j)
        for (int i = 0; i < nx; ++i)
          sum += radiance_at(
              from, {(x + (i + 0.5) / nx) / width, (static_cast<double>(y) + (j + 0.5) / ny) / height});
      for (int c = 0; c < 3; ++c) to.at(x, static_cast<int>(y))[c] = static_cast<float>(sum[c] / (nx * ny));
    }
  });
  return to;
}

// A direction of the lobe around +Z and its weight; `level` is the level of the chain whose pixels are as
// large as the solid angle of a sample.
struct LobeSample {
  glm::dvec3 direction;
  double weight, level;
};

// Returns samples of the lobe of roughness m, for normal = view = mirrored direction.
std::vector<LobeSample> lobe(double m) {
  std::vector<LobeSample> samples;
  const double pixel = 4 * pi / (prefilter_width * (prefilter_width / 2.0));
  for (unsigned i = 0; i < lobe_samples; ++i) {
    // Half vectors from Beckmann's distribution: tan^2 = -m^2 log(1 - u).
    const double tan2 = -m * m * std::log(1 - (i + 0.5) / lobe_samples),
                 azimuth = 2 * pi * radical_inverse(i);
    const double cos2 = 1 / (1 + tan2), c = std::sqrt(cos2), s = std::sqrt(1 - cos2);
    const glm::dvec3 h(s * std::cos(azimuth), s * std::sin(azimuth), c);
    const glm::dvec3 d = 2 * c * h - glm::dvec3(0, 0, 1);
    if (d.z <= 0) continue;

    // Density per sr of the mirrored direction: D cos_h / (4 v.h) = D / 4, because v is the normal.
    const double density = std::exp(-tan2 / (m * m)) / (pi * m * m * cos2 * cos2) / 4;
    samples.push_back({d, d.z, std::max(0.0, 0.5 * std::log2(1 / (lobe_samples * density * pixel)) + 1)});
  }
  return samples;
}

// Returns the mean radiance of the lobe around `axis`, weighted by the cosine.
glm::dvec3 average(const std::vector<image::ImageF>& chain, const std::vector<LobeSample>& samples,
                   const glm::dvec3& axis) {
  const glm::dvec3 side =
      glm::normalize(glm::cross(std::abs(axis.y) < 0.9 ? glm::dvec3(0, 1, 0) : glm::dvec3(1, 0, 0), axis));
  const glm::dvec3 up = glm::cross(axis, side);
  glm::dvec3 sum(0);
  double total = 0;
  for (const LobeSample& s : samples) {
    const glm::dvec2 at = place_of(side * s.direction.x + up * s.direction.y + axis * s.direction.z);
    const double level = std::min(s.level, static_cast<double>(chain.size() - 1));
    const auto low = static_cast<std::size_t>(level), high = std::min(low + 1, chain.size() - 1);
    sum += s.weight * glm::mix(radiance_at(chain[low], at), radiance_at(chain[high], at),
                               level - static_cast<double>(low));
    total += s.weight;
  }
  return sum / total;
}

}  // namespace

std::vector<image::ImageF> prefilter(const Environment& environment) {
  // Downsamples the picture repeatedly, so that a sample reads pixels as large as its share of the lobe.
  std::vector<image::ImageF> chain{resampled(environment.radiance, prefilter_width, prefilter_width / 2)};
  while (chain.back().height > 4)
    chain.push_back(resampled(chain.back(), chain.back().width / 2, chain.back().height / 2));

  std::vector<image::ImageF> levels{chain.front()};
  for (int k = 1; k < prefilter_levels; ++k) {
    const std::vector<LobeSample> samples = lobe(std::exp2(k - (prefilter_levels - 1)));
    image::ImageF level = empty(prefilter_width >> k, prefilter_width / 2 >> k);

    parallel_for(static_cast<std::size_t>(level.height), [&](std::size_t y) {
      for (int x = 0; x < level.width; ++x) {
        const glm::dvec3 mean =
            average(chain, samples,
                    direction_of((x + 0.5) / level.width, (static_cast<double>(y) + 0.5) / level.height));
        for (int c = 0; c < 3; ++c) level.at(x, static_cast<int>(y))[c] = static_cast<float>(mean[c]);
      }
    });
    levels.push_back(std::move(level));
  }
  return levels;
}

}  // namespace dermis::environment
