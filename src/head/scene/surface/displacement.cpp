// SPDX-License-Identifier: MIT
#include "head/scene/surface/displacement.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <glm/gtc/constants.hpp>
#include <vector>

#include "base/core/assert.h"
#include "base/core/hooks.h"
#include "base/core/parallel.h"

namespace dermis::scene {
namespace {

struct Field {
  int width = 0, height = 0;
  std::vector<float> values;
  float& at(int x, int y) {
    return values[static_cast<std::size_t>(y) * static_cast<std::size_t>(width) +
                  static_cast<std::size_t>(x)];
  }
  float at(int x, int y) const {
    return values[static_cast<std::size_t>(y) * static_cast<std::size_t>(width) +
                  static_cast<std::size_t>(x)];
  }
};

Field make_field(int width, int height) {
  return {width, height,
          std::vector<float>(static_cast<std::size_t>(width) * static_cast<std::size_t>(height), 0.f)};
}

int wrapped(int i, int n, AssetWrap wrap) {
  // Nearly all are inside, and a remainder costs as much as all other work on the texel.
  if (i >= 0 && i < n) return i;
  if (wrap == AssetWrap::clamp) return std::clamp(i, 0, n - 1);
  const int period = wrap == AssetWrap::mirror ? 2 * n : n;
  const int r = ((i % period) + period) % period;
  return r < n ? r : period - 1 - r;
}

/// The source texels that one target texel reads, with weights.
struct Taps {
  int first = 0;
  std::vector<float> weights;  ///< sum 1
};

/// Returns a Gaussian around each target centre, in source texels: smoothing and resampling in one step.
std::vector<Taps> gaussian_taps(int source, int target, double sigma) {
  std::vector<Taps> taps(static_cast<std::size_t>(target));
  for (int i = 0; i < target; ++i) {
    const double centre = (i + 0.5) * source / target - 0.5;
    const int reach = static_cast<int>(std::ceil(3.5 * sigma));
    Taps& t = taps[static_cast<std::size_t>(i)];
    t.first = static_cast<int>(std::floor(centre)) - reach;
    double sum = 0;
    std::vector<double> weights;
    for (int k = 0; k < 2 * reach + 2; ++k) {
      const double d = (t.first + k - centre) / sigma;
      weights.push_back(std::exp(-0.5 * d * d));
      sum += weights.back();
    }
    for (const double w : weights) t.weights.push_back(static_cast<float>(w / sum));
  }
  return taps;
}

struct Target {
  int width, height;
};

/// Returns the height map in mm at the target's size, after a Gaussian of sigma source texels per axis.
Field smooth_heights(const image::Image8& heights, const DisplacementSettings& s, Target target,
                     const glm::dvec2& sigma) {
  const std::vector<Taps> across = gaussian_taps(heights.width, target.width, sigma.x),
                          down = gaussian_taps(heights.height, target.height, sigma.y);
  Field rows = make_field(target.width, heights.height), result = make_field(target.width, target.height);
  const double mm_per_step = s.displacement_mm / 255;
  // Extends a row by what its taps reach beyond it: wraps once per texel instead of once per tap.
  const int first = across.front().first,
            end = across.back().first + static_cast<int>(across.back().weights.size());
  Steps steps("smoothing heights",
              static_cast<std::size_t>(heights.height) + static_cast<std::size_t>(target.height));
  parallel_for(static_cast<std::size_t>(heights.height), [&](std::size_t y) {
    std::vector<float> line;
    line.reserve(static_cast<std::size_t>(end - first));
    for (int i = first; i < end; ++i)
      line.push_back(heights.value(wrapped(i, heights.width, s.wrap_u), static_cast<int>(y), s.channel));

    // Tap by tap, in which the compiler sees vectors. A map that keeps its width has the same taps
    // everywhere.
    float* to = &rows.at(0, static_cast<int>(y));
    if (heights.width == target.width) {
      const std::vector<float>& weights = across.front().weights;
      for (std::size_t k = 0; k < weights.size(); ++k)
        for (std::size_t x = 0; x < static_cast<std::size_t>(target.width); ++x)
          to[x] += weights[k] * line[x + k];
    } else {
      for (int x = 0; x < target.width; ++x) {
        const Taps& t = across[static_cast<std::size_t>(x)];
        const float* from = &line[static_cast<std::size_t>(t.first - first)];
        for (std::size_t k = 0; k < t.weights.size(); ++k) to[x] += t.weights[k] * from[k];
      }
    }
    for (int x = 0; x < target.width; ++x) to[x] = static_cast<float>(to[x] * mm_per_step);
    steps.done();
  });

  parallel_for(static_cast<std::size_t>(target.height), [&](std::size_t y) {
    const Taps& t = down[y];
    for (std::size_t k = 0; k < t.weights.size(); ++k) {
      const float* from = &rows.at(0, wrapped(t.first + static_cast<int>(k), heights.height, s.wrap_v));
      float* to = &result.at(0, static_cast<int>(y));
      for (int x = 0; x < target.width; ++x) to[x] += t.weights[k] * from[x];
    }
    steps.done();
  });
  return result;
}

/// Two texels of an axis and their weights, for a place between them.
struct BilinearTap {
  int texel[2];
  double weight[2];
};

std::vector<BilinearTap> bilinear_taps(int source, int target, AssetWrap wrap) {
  std::vector<BilinearTap> taps;
  taps.reserve(static_cast<std::size_t>(target));
  for (int i = 0; i < target; ++i) {
    const double at = (i + 0.5) / target * source - 0.5;
    const int first = static_cast<int>(std::floor(at));
    taps.push_back(
        {{wrapped(first, source, wrap), wrapped(first + 1, source, wrap)}, {1 - at + first, at - first}});
  }
  return taps;
}

/// Returns the slopes (x / z, y / z) of the base map at a place, bilinear. components: of its bytes.
glm::dvec2 base_slopes(const image::Image8& base, double scale, const BilinearTap& across,
                       const BilinearTap& down, const std::array<double, 256>& components) {
  glm::dvec3 n(0);
  for (int dy = 0; dy < 2; ++dy) {
    for (int dx = 0; dx < 2; ++dx) {
      const std::uint8_t* p = base.at(across.texel[dx], down.texel[dy]);
      n += across.weight[dx] * down.weight[dy] *
           glm::dvec3(components[p[0]], components[p[1]], components[p[2]]);
    }
  }
  // Maps store straight up as (128, 128, 255), half a step off zero: invisible, but it must not add up. z
  // stays away from the horizon.
  const auto centred = [](double c) { return std::abs(c) <= 0.5 / 127.5 ? 0.0 : c; };
  return glm::dvec2(centred(n.x), centred(n.y)) * (scale / std::max(n.z, 0.05));
}

/// Returns the byte of a component, -1 to 1; 0 of what is no number.
std::uint8_t encoded(double component) {
  return static_cast<std::uint8_t>(std::max(0.0, std::min((component + 1) * 127.5, 255.0)) + 0.5);
}

}  // namespace

double height_smoothing_texels(double step_mm, double mm_per_texel) {
  constexpr double allowed_slope = 0.0087;  // tan 0.5 degrees
  // Rounding to steps of q mm puts noise of q / sqrt(12) on every height. Its slope after a Gaussian is q /
  // (sqrt(12) spacing sqrt(8 pi) sigma^2); solved for sigma.
  const double noise_mm = std::abs(step_mm) / std::sqrt(12.0);
  const double sigma2 = noise_mm / (mm_per_texel * std::sqrt(8 * glm::pi<double>()) * allowed_slope);
  return std::clamp(std::sqrt(sigma2), 0.7, 2.0);
}

image::Image8 displaced_normals(const image::Image8& heights, const DisplacementSettings& settings,
                                const image::Image8* base) {
  DERMIS_ASSERT_LT(0, std::min(heights.width, heights.height));
  DERMIS_ASSERT_LE(0, settings.channel);
  DERMIS_ASSERT_LE(settings.channel, 3);
  DERMIS_ASSERT_LT(0.0, std::min(settings.mm_per_uv.x, settings.mm_per_uv.y));
  const glm::ivec2 source(heights.width, heights.height),
      other = base != nullptr ? glm::ivec2(base->width, base->height) : glm::ivec2(0);
  const Target target{std::min(std::max(source.x, other.x), max_normal_map_side),
                      std::min(std::max(source.y, other.y), max_normal_map_side)};
  const glm::dvec2 spacing_mm = settings.mm_per_uv / glm::dvec2(target.width, target.height);
  // Downsampling needs at least half a target texel, or heights alias.
  const glm::dvec2 shrink = glm::dvec2(source) / glm::dvec2(target.width, target.height);
  const glm::dvec2 texel_mm = settings.mm_per_uv / glm::dvec2(source);
  const double step_mm = settings.displacement_mm / (heights.rgba16.empty() ? 255 : 65535);
  const glm::dvec2 sigma(std::max(height_smoothing_texels(step_mm, texel_mm.x), 0.5 * shrink.x),
                         std::max(height_smoothing_texels(step_mm, texel_mm.y), 0.5 * shrink.y));
  Steps steps("deriving fine normals", 3);
  Field h = smooth_heights(heights, settings, target, sigma);
  steps.done();
  if (base != nullptr && other.x < source.x && other.y < source.y) {
    const glm::dvec2 base_texel = glm::dvec2(source) / glm::dvec2(other);
    const Field coarse = smooth_heights(heights, settings, target, glm::max(base_texel, sigma));
    for (std::size_t i = 0; i < h.values.size(); ++i) h.values[i] -= coarse.values[i];
  }
  steps.done();

  std::vector<BilinearTap> across, down_base;
  if (base != nullptr) {
    across = bilinear_taps(base->width, target.width, settings.wrap_u);
    down_base = bilinear_taps(base->height, target.height, settings.wrap_v);
  }
  std::array<double, 256> components{};
  for (std::size_t i = 0; i < components.size(); ++i) components[i] = static_cast<double>(i) / 127.5 - 1;

  image::Image8 normals{target.width, target.height, {}};
  normals.rgba.assign(h.values.size() * 4, 255);
  Steps rows("normals", static_cast<std::size_t>(target.height));
  parallel_for(static_cast<std::size_t>(target.height), [&](std::size_t row) {
    const int y = static_cast<int>(row), up = wrapped(y - 1, target.height, settings.wrap_v),
              down = wrapped(y + 1, target.height, settings.wrap_v);
    for (int x = 0; x < target.width; ++x) {
      const int left = wrapped(x - 1, target.width, settings.wrap_u),
                right = wrapped(x + 1, target.width, settings.wrap_u);
      // At a clamped border the neighbours are one texel apart, not two; at a mirrored one the slope is 0 by
      // symmetry.
      const double span_x = settings.wrap_u == AssetWrap::clamp && (x == 0 || x == target.width - 1) ? 1 : 2;
      const double span_y = settings.wrap_v == AssetWrap::clamp && (y == 0 || y == target.height - 1) ? 1 : 2;
      glm::dvec2 slope((h.at(left, y) - h.at(right, y)) / (span_x * spacing_mm.x),
                       (h.at(x, down) - h.at(x, up)) / (span_y * spacing_mm.y));
      if (base != nullptr)
        slope += base_slopes(*base, settings.base_scale, across[static_cast<std::size_t>(x)], down_base[row],
                             components);
      const glm::dvec3 n = glm::normalize(glm::dvec3(slope, 1));
      std::uint8_t* out = normals.at(x, y);
      for (int c = 0; c < 3; ++c) out[c] = encoded(n[c]);
    }
    rows.done();
  });
  return normals;
}

glm::dvec2 mean_mm_per_uv(const SkinMesh& mesh, double mm_per_unit) {
  glm::dvec2 inverse_sum(0);
  double area_sum = 0;
  for (std::size_t i = 0; i + 2 < mesh.indices.size(); i += 3) {
    const auto p = [&](std::size_t k) {
      return glm::dvec3(mesh.vertices[mesh.indices[i + k]].position_m) * mm_per_unit;
    };
    const auto uv = [&](std::size_t k) { return mesh.unwrap[mesh.indices[i + k]]; };
    const glm::dvec3 g = triangle_metric(p(0), p(1), p(2), uv(0), uv(1), uv(2));
    if (!(g.x > 0)) continue;
    const double area = glm::length(glm::cross(p(1) - p(0), p(2) - p(0)));
    inverse_sum += area * glm::dvec2(1 / std::sqrt(g.x), std::sqrt(g.x / (g.x * g.z - g.y * g.y)));
    area_sum += area;
  }
  return area_sum > 0 ? area_sum / inverse_sum : glm::dvec2(300);
}

}  // namespace dermis::scene
