// SPDX-License-Identifier: MIT
#include "viewer/model/light_places.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <glm/glm.hpp>
#include <numbers>
#include <vector>

#include "api/scene_state.h"
#include "api/vectors.h"
#include "head/scene/framing.h"
#include "render/setup/choose.h"

namespace dermis::viewer {
namespace {

using api::array_of, api::vector_of;

constexpr double degrees_per_radian = 180 / std::numbers::pi;

double greatest(const std::array<double, 3>& v) { return *std::max_element(v.begin(), v.end()); }

bool stands_somewhere(const Light& light) { return light.type != LightType::directional; }

double distance_m(const Light& light, const HeadSphere& sphere) {
  if (!stands_somewhere(light)) return 1;
  return std::max(glm::length(vector_of(light.position_m) - vector_of(sphere.centre_m)), 1e-4);
}

}  // namespace

PlacedLight place_of(const Light& light, const HeadSphere& sphere) {
  glm::dvec3 towards = stands_somewhere(light) ? vector_of(light.position_m) - vector_of(sphere.centre_m)
                                               : -vector_of(light.direction);
  if (glm::length(towards) < 1e-9) towards = {0, 0, 1};
  towards = glm::normalize(towards);
  const double d = distance_m(light, sphere);
  return {.azimuth_deg = std::atan2(towards.x, towards.z) * degrees_per_radian,
          .elevation_deg = std::asin(std::clamp(towards.y, -1.0, 1.0)) * degrees_per_radian,
          .irradiance = greatest(light.colour) / (d * d)};
}

Light placed(const Light& light, const PlacedLight& at, const HeadSphere& sphere) {
  Light moved = light;
  const double d = distance_m(light, sphere);
  const glm::dvec3 towards = scene::head_direction(at.azimuth_deg, at.elevation_deg);
  moved.direction = array_of(-towards);
  if (stands_somewhere(light)) moved.position_m = array_of(vector_of(sphere.centre_m) + towards * d);

  const std::array<double, 3> tone = tone_of(light);
  for (std::size_t c = 0; c < 3; ++c) moved.colour[c] = std::clamp(tone[c] * at.irradiance * d * d, 0.0, 1e9);
  return moved;
}

std::array<double, 3> tone_of(const Light& light) {
  const double most = greatest(light.colour);
  if (most <= 0) return {1, 1, 1};
  return {light.colour[0] / most, light.colour[1] / most, light.colour[2] / most};
}

Light with_tone(const Light& light, const std::array<double, 3>& tone) {
  Light coloured = light;
  const double most = greatest(tone), scale = most > 0 ? greatest(light.colour) / most : 0;
  for (std::size_t c = 0; c < 3; ++c) coloured.colour[c] = std::max(tone[c], 0.0) * scale;
  return coloured;
}

HeadSphere in_rig(const HeadSphere& sphere, const Scene& scene, const SceneLight& light) {
  if (!light.rig) return sphere;
  const std::array<double, 16>& m = scene.instance(*light.rig).world_from_asset;
  glm::dmat4 world_from_rig;
  for (int column = 0; column < 4; ++column)
    for (int row = 0; row < 4; ++row)
      world_from_rig[column][row] = m[static_cast<std::size_t>(4 * column + row)];
  const glm::dmat4 rig_from_world = glm::inverse(world_from_rig);
  return {array_of(glm::dvec3(rig_from_world * glm::dvec4(vector_of(sphere.centre_m), 1))),
          sphere.radius_m * glm::length(glm::dvec3(rig_from_world[0]))};
}

bool draws_scene_lights(const Document& document) {
  const LightingSettings& lighting = document.settings.lighting;
  return !lighting.rig_lights && lighting.placed_lights.empty() && !document.scene.lights().empty();
}

void own_lights(Document& document) {
  const setup::PlacedScene placed = api::placed_scene(document.scene);
  RenderSettings settings = document.settings;
  settings.lighting.light_radius_m.reset();
  const std::vector<scene::Light> lights =
      setup::choose_lights(placed, settings, setup::head_spheres(placed, settings));
  for (const LightId id : document.scene.lights()) document.scene.remove_light(id);
  for (const scene::Light& light : lights) document.scene.add_light({.light = api::light_of(light)});

  document.settings.lighting.placed_lights.clear();
  document.settings.lighting.rig_lights.reset();
  // A scene without any has the rig.
  if (lights.empty()) document.settings.lighting.rig_lights = 0;
}

LightId add_lamp(Document& document, const PlacedLight& at) {
  own_lights(document);
  document.settings.lighting.rig_lights.reset();
  const setup::PlacedScene placed = api::placed_scene(document.scene);
  const setup::HeadSpheres spheres = setup::head_spheres(placed, document.settings);
  const std::string name = fmt::format("lamp {}", document.scene.lights().size() + 1);
  const std::vector<scene::Lamp> lamp{{name, at.azimuth_deg, at.elevation_deg, glm::dvec3(at.irradiance)}};
  return document.scene.add_light(
      {.light = api::light_of(scene::light_rig(spheres.lit, lamp, spheres.offsets_m).front())});
}

}  // namespace dermis::viewer
