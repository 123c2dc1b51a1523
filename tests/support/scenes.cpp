// SPDX-License-Identifier: MIT
#include "support/scenes.h"

#include <cmath>
#include <numbers>
#include <utility>

namespace dermis::tests {

scene::Camera camera_from_above(double half_height_m, const glm::vec3& position_m) {
  scene::Camera camera;
  camera.name = "above";
  camera.world_from_camera[3] = glm::vec4(position_m, 1);
  camera.orthographic = true;
  camera.ymag_m = static_cast<float>(half_height_m);
  camera.znear_m = 1e-4f;
  return camera;
}

scene::Camera camera_from_aside(double half_height_m, double angle_deg) {
  const auto angle = static_cast<float>(angle_deg * std::numbers::pi / 180);
  const float up = std::cos(angle), aside = std::sin(angle);
  scene::Camera camera = camera_from_above(half_height_m, {0.1f * aside, 0, 0.1f * up});
  camera.world_from_camera[0] = {up, 0, -aside, 0};
  camera.world_from_camera[2] = {aside, 0, up, 0};
  return camera;
}

scene::Light directional_light(const glm::vec3& direction, const glm::vec3& irradiance) {
  scene::Light light;
  light.colour = irradiance;
  light.direction = glm::normalize(direction);
  return light;
}

void add_sheet(scene::AssetData& made, float size_m, float z_m) {
  scene::Primitive sheet{.name = "sheet", .material = static_cast<int>(made.materials.size())};
  made.materials.push_back({.name = "sheet"});
  for (int i = 0; i < 4; ++i) {
    scene::Vertex v;
    v.position_m = {i & 1 ? size_m : 0.0f, i & 2 ? size_m : -size_m, z_m};
    sheet.vertices.push_back(v);
  }
  sheet.indices = {0, 1, 3, 0, 3, 2};
  made.primitives.push_back(std::move(sheet));
}

}  // namespace dermis::tests
