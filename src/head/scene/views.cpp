// SPDX-License-Identifier: MIT
#include "head/scene/views.h"

#include <cmath>

namespace dermis::scene {
namespace {

/// Returns the rotation of a node without its scale; it looks along -Z.
glm::dmat3 rotation_of(const glm::dmat4& world) {
  const glm::dvec3 z(world[2]), y(world[1]);
  const glm::dvec3 back = glm::length(z) > 0 ? glm::normalize(z) : glm::dvec3(0, 0, 1);
  const glm::dvec3 side = glm::cross(y, back);
  const glm::dvec3 any = std::abs(back.y) < 0.9 ? glm::dvec3(0, 1, 0) : glm::dvec3(1, 0, 0);
  const glm::dvec3 right =
      glm::normalize(glm::length(side) > 1e-9 * glm::length(y) ? side : glm::cross(any, back));
  return {right, glm::cross(back, right), back};
}

}  // namespace

void stand_at(const glm::dmat4& world, Camera& camera) {
  camera.world_from_camera = glm::mat4(glm::dmat4(rotation_of(world)));
  camera.world_from_camera[3] = glm::vec4(glm::vec3(world[3]), 1);
}

void stand_at(const glm::dmat4& world, Light& light) {
  light.position_m = glm::vec3(world[3]);
  light.direction = glm::vec3(-rotation_of(world)[2]);
}

}  // namespace dermis::scene
