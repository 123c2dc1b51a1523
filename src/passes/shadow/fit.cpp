// SPDX-License-Identifier: MIT
#include "passes/shadow/fit.h"

#include <algorithm>
#include <cmath>
#include <glm/gtc/matrix_transform.hpp>

namespace dermis::passes {
namespace {

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

}  // namespace

ShadowFit fit_shadow(const scene::Light& light, const scene::BoundingSphere& sphere, int map_size) {
  // A margin of a few texels keeps the filter inside the map.
  const float margin = 1 + 8.0f / static_cast<float>(map_size);
  const float radius = std::max(sphere.radius_m, 1e-6f);
  const float size = static_cast<float>(map_size);

  if (light.type == scene::LightType::directional) {
    const float half = radius * margin;
    const glm::vec3 eye = sphere.centre_m - light.direction * (2 * radius);
    return {{orthographic(half, 0.9f * radius, 3.1f * radius) * view(eye, light.direction)}, 2 * half / size};
  }

  const glm::vec3 to_centre = sphere.centre_m - light.position_m;
  const float distance = glm::length(to_centre);
  if (distance > 1.1f * radius) {
    const float sine = radius / distance;
    const float tan_half = sine / std::sqrt(1 - sine * sine) * margin;
    return {{perspective(tan_half, (distance - radius) * 0.9f, distance + radius * 1.1f) *
             view(light.position_m, to_centre / distance)},
            2 * tan_half / size};
  }

  // The light is inside the sphere, or nearly: one layer per direction of the axes.
  const float near_m = radius * 0.005f, far_m = (distance + radius) * 1.1f;
  ShadowFit fit{.shadow_from_world = {}, .texel = 2 * margin / size};
  for (const glm::vec3& axis : {glm::vec3(1, 0, 0), glm::vec3(-1, 0, 0), glm::vec3(0, 1, 0),
                                glm::vec3(0, -1, 0), glm::vec3(0, 0, 1), glm::vec3(0, 0, -1)})
    fit.shadow_from_world.push_back(perspective(margin, near_m, far_m) * view(light.position_m, axis));
  return fit;
}

}  // namespace dermis::passes
