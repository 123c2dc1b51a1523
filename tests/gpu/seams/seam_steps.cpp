// SPDX-License-Identifier: MIT
#include "gpu/seams/seam_steps.h"
#include "api/scene_state.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <optional>
#include <tuple>

#include "api/prepare/reference_setup.h"
#include "rays/surface_point.h"
#include "truth/reference/camera_ray.h"

namespace dermis::tests {
namespace {

constexpr int run_length_px = 16;  // of a piece of a seam, along its way

/// What the middle of a pixel shows.
struct Sample {
  bool skin = false;
  glm::dvec2 uv{0};
  glm::dvec3 position_m{0}, normal{0};
  bool lit = false;  ///< no solid triangle between it and the light
};

class Pixels {
 public:
  Pixels(const Scene& scene, const RenderSettings& settings)
      : view_(api::reference_setup(api::placed_scene(scene), settings)), rays_(api::only_asset(scene)) {
    const glm::dvec3 light_m(view_.lights.at(0).position_m);

    samples_.resize(static_cast<std::size_t>(view_.width) * static_cast<std::size_t>(view_.height));
    for (int y = 0; y < view_.height; ++y)
      for (int x = 0; x < view_.width; ++x) {
        const std::optional<rays::Hit> hit = rays_.nearest(reference::camera_ray(view_, x + 0.5, y + 0.5));
        if (!hit || !rays::is_skin(api::only_asset(scene), api::only_asset(scene).primitives[hit->primitive]))
          continue;

        const rays::SurfacePoint point = rays::surface_point(api::only_asset(scene), *hit);
        const glm::dvec3 way = light_m - point.shadow_origin_m;
        const rays::Ray to_light{
            .origin_m = point.shadow_origin_m, .direction = glm::normalize(way), .t_max_m = glm::length(way)};
        at(x, y) = {.skin = true,
                    .uv = point.uv[0],
                    .position_m = point.position_m,
                    .normal = point.normal,
                    .lit = !rays_.solid_between(to_light)};
      }
  }

  int width() const { return view_.width; }
  int height() const { return view_.height; }
  Sample& at(int x, int y) { return samples_[static_cast<std::size_t>(y * view_.width + x)]; }
  const Sample& at(const glm::ivec2& p) const {
    return samples_[static_cast<std::size_t>(p.y * view_.width + p.x)];
  }

 private:
  reference::RenderSetup view_;
  rays::RayScene rays_;
  std::vector<Sample> samples_;
};

// Steps between four in a row: before, across, after.
template <class Value>
std::array<double, 3> steps(const std::array<Sample, 4>& s, Value Sample::*value) {
  return {glm::distance(s[0].*value, s[1].*value), glm::distance(s[1].*value, s[2].*value),
          glm::distance(s[2].*value, s[3].*value)};
}

// Four in a row on one surface, between the second and third of which texture coordinates jump.
bool crosses(const std::array<Sample, 4>& s) {
  if (!std::all_of(s.begin(), s.end(), [](const Sample& sample) { return sample.skin; })) return false;

  // Across an outline in front of other skin, one of the three ways is far longer than the others.
  const std::array<double, 3> ways = steps(s, &Sample::position_m), uv = steps(s, &Sample::uv);
  const auto [least, most] = std::minmax_element(ways.begin(), ways.end());
  return *most < 2 * *least && uv[1] > 6 * std::max(uv[0], uv[2]);
}

bool in_shadow_edge(const std::array<Sample, 4>& s) {
  return std::any_of(s.begin(), s.end(), [&](const Sample& other) { return other.lit != s[0].lit; });
}

// Normals that turn faster across the seam than beside it: the light steps because the file says so.
bool is_creased(const std::array<Sample, 4>& s) {
  const std::array<double, 3> turns = steps(s, &Sample::normal);
  return turns[1] > std::max(turns[0], turns[2]) + 0.01;
}

/// Numbers pieces of seams: the square of the picture, the way through it and the way of the jump. The two
/// sides of a narrow chart jump in opposite ways, so their steps are not taken together.
class Runs {
 public:
  std::size_t number(const glm::ivec2& pixel, const glm::ivec2& step, const glm::dvec2& jump) {
    const glm::ivec2 square = pixel / run_length_px;
    const std::tuple key{square.x, square.y, step.x, jump.x > 0, jump.y > 0};
    return numbers_.try_emplace(key, numbers_.size()).first->second;
  }
  std::size_t count() const { return numbers_.size(); }

 private:
  std::map<std::tuple<int, int, int, bool, bool>, std::size_t> numbers_;
};

}  // namespace

Crossings find_crossings(const Scene& scene, const RenderSettings& settings) {
  const Pixels pixels(scene, settings);
  Crossings found;
  Runs runs;

  for (const glm::ivec2 step : {glm::ivec2(1, 0), glm::ivec2(0, 1)})
    for (int y = 0; y + 3 * step.y < pixels.height(); ++y)
      for (int x = 0; x + 3 * step.x < pixels.width(); ++x) {
        const glm::ivec2 first(x, y);
        const std::array<Sample, 4> four{pixels.at(first), pixels.at(first + step),
                                         pixels.at(first + 2 * step), pixels.at(first + 3 * step)};
        if (!crosses(four)) continue;
        if (in_shadow_edge(four)) {
          ++found.in_shadow_edges;
          continue;
        }
        if (is_creased(four)) {
          ++found.creased;
          continue;
        }

        const std::size_t run = runs.number(first, step, four[2].uv - four[1].uv);
        found.all.push_back({.first = first, .step = step, .run = run});
      }
  found.runs = runs.count();
  return found;
}

Excess seam_excess(const Crossings& crossings, const Picture& picture, const Picture& unmapped,
                   std::size_t least) {
  struct Sums {
    std::size_t count = 0;
    std::array<glm::dvec3, 4> steps{};  // before, across, after; across without maps
    glm::ivec2 pixel{0};
  };
  std::vector<Sums> runs(crossings.runs);
  const auto shown = [](const Picture& of, const glm::ivec2& p) {
    const std::size_t i = 4 * static_cast<std::size_t>(p.y * of.width + p.x);
    return glm::dvec3(of.display_rgba[i], of.display_rgba[i + 1], of.display_rgba[i + 2]);
  };

  for (const Crossing& c : crossings.all) {
    Sums& sums = runs[c.run];
    ++sums.count;
    sums.pixel = c.first + c.step;
    for (int i = 0; i < 3; ++i)
      sums.steps[static_cast<std::size_t>(i)] +=
          shown(picture, c.first + (i + 1) * c.step) - shown(picture, c.first + i * c.step);
    sums.steps[3] += shown(unmapped, c.first + 2 * c.step) - shown(unmapped, c.first + c.step);
  }

  Excess excess;
  for (const Sums& sums : runs) {
    if (sums.count < least) continue;
    ++excess.runs;
    for (int c = 0; c < 3; ++c) {
      const auto step = [&](std::size_t i) {
        return std::abs(sums.steps[i][c]) / static_cast<double>(sums.count);
      };
      const double more = step(1) - std::max({step(0), step(2), step(3)});
      if (more > excess.largest) {
        excess.largest = more;
        excess.pixel = sums.pixel;
      }
    }
  }
  return excess;
}

Picture read_off(const Scene& scene, const RenderSettings& settings, const Picture& picture, double texels) {
  constexpr int reach_px = 6;
  const Pixels pixels(scene, settings);
  const glm::ivec2 size(pixels.width(), pixels.height());
  const glm::dvec2 off(-texels / settings.quality.map_size, 0);

  const auto nearest = [&](const glm::ivec2& p) {
    const glm::dvec2 wanted = pixels.at(p).uv + off;
    glm::ivec2 best = p;
    for (int y = std::max(p.y - reach_px, 0); y <= std::min(p.y + reach_px, size.y - 1); ++y)
      for (int x = std::max(p.x - reach_px, 0); x <= std::min(p.x + reach_px, size.x - 1); ++x) {
        const Sample& other = pixels.at({x, y});
        if (other.skin && glm::distance(other.uv, wanted) < glm::distance(pixels.at(best).uv, wanted))
          best = {x, y};
      }
    return best;
  };

  Picture moved = picture;
  for (int y = 0; y < size.y; ++y)
    for (int x = 0; x < size.x; ++x) {
      const Sample& here = pixels.at({x, y});
      if (!here.skin || here.uv.x < 0.5) continue;
      const glm::ivec2 from = nearest({x, y});
      std::copy_n(&picture.display_rgba[4 * static_cast<std::size_t>(from.y * size.x + from.x)], 4,
                  &moved.display_rgba[4 * static_cast<std::size_t>(y * size.x + x)]);
    }
  return moved;
}

}  // namespace dermis::tests
