// SPDX-License-Identifier: MIT
#include "render/passes/shadow/fit.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <glm/gtc/constants.hpp>
#include <glm/gtc/matrix_transform.hpp>

namespace dermis::passes {
namespace {

// Turns of a map about the light's direction that are tried: a square is the same after a quarter turn.
constexpr std::size_t turns = 8;
constexpr float turn_rad = glm::half_pi<float>() / turns;

// Returns a view along `forward` from `eye`, with any up direction: the map is not shown.
glm::mat4 view(const glm::vec3& eye, const glm::vec3& forward) {
  const glm::vec3 up = std::abs(forward.y) < 0.9f ? glm::vec3(0, 1, 0) : glm::vec3(1, 0, 0);
  return glm::lookAt(eye, eye + forward, up);
}

// Reversed depth: near -> 1, far -> 0. y needs no flip: the map is read with the same matrix that draws it.
glm::mat4 perspective(float tan_half, float near_m, float far_m) {
  glm::mat4 m(0);
  m[0][0] = m[1][1] = 1 / tan_half;
  m[2][2] = near_m / (far_m - near_m);
  m[3][2] = near_m * far_m / (far_m - near_m);
  m[2][3] = -1;
  return m;
}

glm::mat4 orthographic(float half, float near_m, float far_m) {
  glm::mat4 m(1);
  m[0][0] = m[1][1] = 1 / half;
  m[2][2] = 1 / (far_m - near_m);
  m[3][2] = far_m / (far_m - near_m);
  return m;
}

float radius_of(const ShadowBounds& bounds) { return std::max(bounds.sphere.radius_m, 1e-6f); }

// Of a map, so that a few texels keep the filter inside.
float margin_of(float size) { return 1 + 8 / size; }

// Shifts what is projected, so that `middle` (-1 to 1 across the map) becomes its middle.
glm::mat4 off_axis(const glm::vec2& middle) {
  glm::mat4 m(1);
  m[3] = glm::vec4(-middle, 0, 1);
  return m;
}

// The part of a light's view that is drawn.
struct Window {
  glm::mat4 view_from_world;
  float half = 0;  // half its side: m, or m per m of distance
  float near_m = 0, far_m = 0;
  glm::vec2 middle{0};  // off the axis, as `half`
};

// A square around points of a plane.
struct Square {
  float turn_rad = 0;  // of its sides against the plane's axes
  glm::vec2 middle{0};
  float half = 0;
};

// Returns the smallest square of those with the turns that are tried.
template <class Project>
Square square_around(std::span<const glm::vec3> points_m, const Project& project) {
  std::array<glm::vec2, turns> direction, low, high;
  for (std::size_t turn = 0; turn < turns; ++turn) {
    const float angle_rad = turn_rad * static_cast<float>(turn);
    direction[turn] = {std::cos(angle_rad), std::sin(angle_rad)};
    low[turn] = glm::vec2(HUGE_VALF);
    high[turn] = glm::vec2(-HUGE_VALF);
  }

  for (const glm::vec3& p_m : points_m) {
    const glm::vec2 p = project(p_m);
    for (std::size_t turn = 0; turn < turns; ++turn) {
      const glm::vec2 d = direction[turn], at(d.x * p.x - d.y * p.y, d.y * p.x + d.x * p.y);
      low[turn] = glm::min(low[turn], at);
      high[turn] = glm::max(high[turn], at);
    }
  }

  Square best{.half = HUGE_VALF};
  for (std::size_t turn = 0; turn < turns; ++turn) {
    const glm::vec2 d = direction[turn], sides = high[turn] - low[turn],
                    middle = 0.5f * (low[turn] + high[turn]);
    const float half = 0.5f * std::max(sides.x, sides.y);
    if (half < best.half)
      best = {turn_rad * static_cast<float>(turn),
              {d.x * middle.x + d.y * middle.y, d.x * middle.y - d.y * middle.x},
              half};
  }
  return best;
}

glm::mat4 turned(float angle_rad, const glm::mat4& view_from_world) {
  return glm::rotate(glm::mat4(1), angle_rad, glm::vec3(0, 0, 1)) * view_from_world;
}

// Where points lie in a light's view.
struct Extent {
  glm::vec2 low{HUGE_VALF}, high{-HUGE_VALF};
  float nearest_m = HUGE_VALF, farthest_m = -HUGE_VALF;
};

template <class Project>
Extent extent_of(std::span<const glm::vec3> points_m, const glm::mat4& view_from_world,
                 const Project& project) {
  Extent extent;
  for (const glm::vec3& p_m : points_m) {
    const glm::vec3 p(view_from_world * glm::vec4(p_m, 1));
    const glm::vec2 at = project(p);
    extent.low = glm::min(extent.low, at);
    extent.high = glm::max(extent.high, at);
    extent.nearest_m = std::min(extent.nearest_m, -p.z);
    extent.farthest_m = std::max(extent.farthest_m, -p.z);
  }
  return extent;
}

glm::vec2 along_axis(const glm::vec3& p) { return {p.x, p.y}; }
glm::vec2 on_plane(const glm::vec3& p) { return glm::vec2(p) / -p.z; }

// Narrows near and far to the points, less a margin, where that is nearer than what the sphere has.
void narrow_depth(Window& window, std::span<const glm::vec3> points_m, float margin_m) {
  const Extent extent = extent_of(points_m, window.view_from_world, along_axis);
  window.near_m = std::max(window.near_m, extent.nearest_m - margin_m);
  window.far_m = std::min(window.far_m, extent.farthest_m + margin_m);
}

Window directional_window(const glm::vec3& direction, const ShadowBounds& bounds) {
  const float radius_m = radius_of(bounds);
  const glm::vec3 eye = bounds.sphere.centre_m - direction * (2 * radius_m);
  Window window{view(eye, direction), radius_m, 0.9f * radius_m, 3.1f * radius_m};
  if (bounds.corners_m.empty()) return window;

  const Square square = square_around(bounds.corners_m, [&](const glm::vec3& p_m) {
    return glm::vec2(window.view_from_world * glm::vec4(p_m, 1));
  });
  if (square.half >= radius_m) return window;

  window.half = std::max(square.half, 1e-3f * radius_m);
  window.view_from_world = turned(
      square.turn_rad, glm::translate(glm::mat4(1), glm::vec3(-square.middle, 0)) * window.view_from_world);
  narrow_depth(window, bounds.corners_m, 0.1f * radius_m);
  return window;
}

bool is_outside(const glm::vec3& position_m, const ShadowBounds& bounds) {
  return glm::distance(bounds.sphere.centre_m, position_m) > 1.1f * radius_of(bounds);
}

// For a light outside the sphere.
Window perspective_window(const glm::vec3& position_m, const ShadowBounds& bounds) {
  const float radius_m = radius_of(bounds);
  const glm::vec3 to_centre = bounds.sphere.centre_m - position_m;
  const float distance = glm::length(to_centre);
  const float sine = radius_m / distance;
  Window window{view(position_m, to_centre / distance), sine / std::sqrt(1 - sine * sine),
                (distance - radius_m) * 0.9f, distance + radius_m * 1.1f};
  if (bounds.corners_m.empty()) return window;

  const auto tangents = [](const glm::mat4& view_from_world) {
    return [view_from_world](const glm::vec3& p_m) {
      return on_plane(glm::vec3(view_from_world * glm::vec4(p_m, 1)));
    };
  };

  // The middle of the square becomes the axis, which changes the square a little.
  Window tight = window;
  Square square = square_around(bounds.corners_m, tangents(window.view_from_world));
  for (int i = 0; i < 2; ++i) {
    const glm::vec3 axis = glm::transpose(glm::mat3(tight.view_from_world)) * glm::vec3(square.middle, -1);
    tight.view_from_world = view(position_m, glm::normalize(axis));
    square = square_around(bounds.corners_m, tangents(tight.view_from_world));
  }

  const float off_axis = std::max(std::abs(square.middle.x), std::abs(square.middle.y));
  tight.half = std::max(square.half + 1.5f * off_axis, 1e-3f * window.half);
  if (!(tight.half < window.half)) return window;
  tight.view_from_world = turned(square.turn_rad, tight.view_from_world);
  narrow_depth(tight, bounds.corners_m, 0.1f * radius_m);
  return tight;
}

// Returns the window of the rest, with sides by steps and shifted by whole texels to hold what has moved.
Window steady_window(const Window& rest, const Extent& extent, float size) {
  const glm::vec2 sides = extent.high - extent.low, middle = 0.5f * (extent.low + extent.high);
  // Half a texel more, by which the middle may be off.
  const float needed = std::max(0.5f * std::max(sides.x, sides.y), 1e-3f * rest.half) * (1 + 1 / size);

  Window window = rest;
  window.half = rest.half * std::exp2(std::ceil(16 * std::log2(needed / rest.half)) / 16);
  const float texel = 2 * window.half * margin_of(size) / size;
  window.middle = glm::round(middle / texel) * texel;
  return window;
}

Window directional_window(const glm::vec3& direction, const ShadowBounds& bounds, float size) {
  if (!bounds.rest) return directional_window(direction, bounds);
  const Window rest = directional_window(direction, *bounds.rest);
  const Extent extent = extent_of(bounds.corners_m, rest.view_from_world, along_axis);

  Window window = steady_window(rest, extent, size);
  const float margin_m = 0.1f * radius_of(bounds);
  window.near_m = extent.nearest_m - margin_m;
  window.far_m = extent.farthest_m + margin_m;
  return window;
}

Window perspective_window(const glm::vec3& position_m, const ShadowBounds& bounds, float size) {
  if (!bounds.rest || !is_outside(position_m, *bounds.rest)) return perspective_window(position_m, bounds);
  const Window rest = perspective_window(position_m, *bounds.rest);
  const Extent extent = extent_of(bounds.corners_m, rest.view_from_world, on_plane);

  // A body that has moved far off the axis would have stretched texels.
  constexpr float most_off_axis = 0.5f;
  const glm::vec2 off_axis = 0.5f * glm::abs(extent.low + extent.high);
  if (!(extent.nearest_m > 0) || std::max(off_axis.x, off_axis.y) > most_off_axis)
    return perspective_window(position_m, bounds);

  Window window = steady_window(rest, extent, size);
  window.near_m = std::max(0.9f * extent.nearest_m, extent.nearest_m - 0.1f * radius_of(bounds));
  window.far_m = extent.farthest_m + 0.1f * radius_of(bounds);
  return window;
}

// For a light inside the sphere, or nearly: one layer per direction of the axes.
ShadowFit cube(const glm::vec3& position_m, const scene::BoundingSphere& sphere, float radius_m, float margin,
               float size) {
  const float distance = glm::length(sphere.centre_m - position_m);
  const float near_m = radius_m * 0.005f, far_m = (distance + radius_m) * 1.1f;
  ShadowFit fit{.shadow_from_world = {}, .texel = 2 * margin / size};
  for (const glm::vec3& axis : {glm::vec3(1, 0, 0), glm::vec3(-1, 0, 0), glm::vec3(0, 1, 0),
                                glm::vec3(0, -1, 0), glm::vec3(0, 0, 1), glm::vec3(0, 0, -1)})
    fit.shadow_from_world.push_back(perspective(margin, near_m, far_m) * view(position_m, axis));
  return fit;
}

}  // namespace

ShadowFit fit_shadow(const scene::Light& light, const ShadowBounds& bounds, int side) {
  const float size = static_cast<float>(side), margin = margin_of(size);
  if (light.type == LightType::directional) {
    const Window w = directional_window(light.direction, bounds, size);
    const float half_m = w.half * margin;
    return {{off_axis(w.middle / half_m) * orthographic(half_m, w.near_m, w.far_m) * w.view_from_world},
            2 * half_m / size};
  }

  if (is_outside(light.position_m, bounds)) {
    const Window w = perspective_window(light.position_m, bounds, size);
    const float tan_half = w.half * margin;
    return {{off_axis(w.middle / tan_half) * perspective(tan_half, w.near_m, w.far_m) * w.view_from_world},
            2 * tan_half / size};
  }
  return cube(light.position_m, bounds.sphere, radius_of(bounds), margin, size);
}

}  // namespace dermis::passes
