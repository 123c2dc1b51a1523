// SPDX-License-Identifier: MIT
#include "cli/test_scenes/test_scenes.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <utility>

#include "api/asset_state.h"
#include "base/core/cache.h"
#include "base/core/error.h"
#include "base/core/hooks.h"
#include "base/core/known_names.h"
#include "cli/test_scenes/shapes.h"
#include "head/builtin_head/builtin_head.h"
#include "head/scene/framing.h"
#include "head/scene/surface/measured.h"

namespace dermis::cli::test_scenes {
namespace {

using std::numbers::pi;

constexpr double far_m = 0.5;  // from the camera to small shapes

double fov_deg(double height_m, double distance_m) {
  return 2 * std::atan(height_m / (2 * distance_m)) * 180 / pi;
}

/// Looks at a point from `distance_m`, and sees so much of the height there.
scene::Camera camera(double azimuth_deg, double height_m, const glm::dvec3& target_m = {},
                     double distance_m = far_m) {
  return scene::look_at_camera(target_m + distance_m * scene::head_direction(azimuth_deg, 0), target_m,
                               fov_deg(height_m, distance_m));
}

/// From so far away that its rays are parallel; irradiance pi on white Lambert shows 1.
scene::Light sun(double azimuth_deg, double elevation_deg, double irradiance = pi) {
  scene::Light light;
  light.name = "sun";
  light.colour = glm::vec3(static_cast<float>(irradiance));
  light.direction = -glm::vec3(scene::head_direction(azimuth_deg, elevation_deg));
  return light;
}

Asset asset_of(scene::AssetData made) { return Asset::State::make(scene::measured(std::move(made))); }

/// The built-in head without a name of a file: what follows changes it.
scene::AssetData head(const Hooks& hooks) {
  const HookScope scope(hooks);
  return builtin_head::make({.cache = cache::default_folder()});
}

scene::AssetData tilted(double tilt_deg) {
  scene::AssetData made = lit_half_plane(LitHalf::below_x, 0);
  made.cameras.push_back(camera(tilt_deg, 0.06));
  made.lights.push_back(sun(0, 0));
  return made;
}

scene::AssetData nose() {
  scene::AssetData made = nose_on_cheek();
  made.cameras.push_back(camera(52, 0.09, {0, 0, 0.01}));
  made.lights.push_back(sun(-50, 15));
  return made;
}

scene::AssetData outside() {
  constexpr double seen_m = 0.06;
  scene::AssetData made = lit_half_plane(LitHalf::below_y, -seen_m / 2 - 0.0005);
  made.cameras.push_back(camera(0, seen_m));
  made.lights.push_back(sun(0, 0));
  return made;
}

scene::AssetData thin_ear() {
  scene::AssetData made = thin_lens();
  made.cameras.push_back(camera(25, 0.08));
  made.lights.push_back(sun(170, 10));
  return made;
}

scene::AssetData curl() {
  scene::AssetData made = open_curl();
  made.cameras.push_back(camera(55, 0.056));
  made.lights.push_back(sun(100, 10));
  return made;
}

scene::AssetData silhouettes() {
  scene::AssetData made = fringe();
  made.cameras.push_back(camera(0, 0.08));
  made.lights.push_back(sun(60, 20));
  return made;
}

scene::AssetData small_head(int picture_height, const Hooks& hooks) {
  constexpr double pixels = 30, fov = 20;
  scene::AssetData made = head(hooks);
  const scene::Bounds bounds = scene::skin_bounds(made);
  const double height_m = double{bounds.high_m.y} - double{bounds.low_m.y},
               seen_m = height_m * std::max(picture_height, 1) / pixels;
  made.cameras.assign(1, camera(0, seen_m, bounds.sphere.centre_m, seen_m / (2 * std::tan(fov * pi / 360))));
  return made;
}

scene::AssetData two_eyes(const Hooks& hooks) {
  constexpr double between_m = 0.063, distance_m = 0.8;
  scene::AssetData made = head(hooks);
  const glm::dvec3 target_m = scene::skin_bounds(made).sphere.centre_m;
  made.cameras.clear();
  for (const double side : {-1.0, 1.0}) {
    const glm::dvec3 eye_m = target_m + glm::dvec3(side * between_m / 2, 0, distance_m);
    // Both look straight ahead, as a pair of displays does: only their places differ.
    made.cameras.push_back(
        scene::look_at_camera(eye_m, eye_m - glm::dvec3(0, 0, distance_m), fov_deg(0.34, distance_m)));
    made.cameras.back().name = side < 0 ? "left" : "right";
  }
  return made;
}

scene::AssetData without_perspective(const Hooks& hooks) {
  scene::AssetData made = head(hooks);
  const scene::BoundingSphere sphere = scene::skin_bounds(made).sphere;
  scene::Camera camera = scene::look_at_camera(
      glm::dvec3(sphere.centre_m) + 1.0 * scene::head_direction(25, 5), glm::dvec3(sphere.centre_m));
  camera.orthographic = true;
  camera.ymag_m = 0.85f * sphere.radius_m;
  made.cameras.assign(1, camera);
  return made;
}

/// The head at the back is lit, that in front is turned to the dark.
Scene overlapping_heads(const Hooks& hooks) {
  const Asset asset = asset_of(head(hooks));
  Scene scene;
  for (const double back_m : {0.0, 0.25}) {
    Instance instance{.asset = asset};
    instance.world_from_asset[12] = 0.6 * back_m;
    instance.world_from_asset[14] = -back_m;
    scene.add(instance);
  }
  const glm::dvec3 to_light = scene::head_direction(70, 15);
  Light light;
  light.name = "sun";
  light.colour = {pi, pi, pi};
  light.direction = {-to_light.x, -to_light.y, -to_light.z};
  scene.add_light({.light = light});
  return scene;
}

struct Row {
  TestScene scene;
  scene::AssetData (*make)(int picture_height, const Hooks& hooks);  ///< null: of several instances
};

template <int Degrees>
scene::AssetData turned(int, const Hooks&) {
  return tilted(Degrees);
}

template <scene::AssetData (*Make)()>
scene::AssetData plain(int, const Hooks&) {
  return Make();
}

template <scene::AssetData (*Make)(const Hooks&)>
scene::AssetData of_head(int, const Hooks& hooks) {
  return Make(hooks);
}

constexpr std::array rows{
    Row{{"tilt-0", "a plane that faces the camera, lit to an edge", false}, turned<0>},
    Row{{"tilt-30", "the same, turned by 30 degrees about the edge", false}, turned<30>},
    Row{{"tilt-60", "turned by 60 degrees: half as many pixels per mm along the tilt", false}, turned<60>},
    Row{{"tilt-75", "turned by 75 degrees: a quarter as many", false}, turned<75>},
    Row{{"nose", "a nose before a cheek: light that the nose hides spreads into what is seen", false},
        plain<nose>},
    Row{{"outside", "skin that is lit half a millimetre below the picture", false}, plain<outside>},
    Row{{"two-heads", "two heads that overlap in depth: no light goes from one to the other", true}, nullptr},
    Row{{"thin-ear", "3 mm of skin, lit from behind", false}, plain<thin_ear>},
    Row{{"open-curl", "an open curl, lit from its own side: light crosses the shell and the gap", false},
        plain<curl>},
    Row{{"30-pixels", "a head 30 pixels high: Gaussians are narrower than a pixel", true}, small_head},
    Row{{"stereo", "a head seen by two eyes, 63 mm apart: cameras left and right", true}, of_head<two_eyes>},
    Row{{"orthographic", "a head without perspective", true}, of_head<without_perspective>},
    Row{{"fringe", "silhouettes everywhere: what --msaa 4 or 1 makes of them", false}, plain<silhouettes>},
};

const Row& row_of(std::string_view name) {
  std::vector<std::string_view> names;
  for (const Row& row : rows) {
    if (row.scene.name == name) return row;
    names.emplace_back(row.scene.name);
  }
  throw input_error("", "test scene {}", unknown_name(name, names));
}

}  // namespace

std::vector<TestScene> all() {
  std::vector<TestScene> scenes;
  for (const Row& row : rows) scenes.push_back(row.scene);
  return scenes;
}

Scene make(std::string_view prefixed_name, int picture_height, const Hooks& hooks) {
  const Row& row = row_of(prefixed_name.substr(std::min(prefix.size(), prefixed_name.size())));
  if (!row.make) return overlapping_heads(hooks);
  scene::AssetData made = row.make(picture_height, hooks);
  made.name = prefixed_name;
  return Scene(asset_of(std::move(made)));
}

}  // namespace dermis::cli::test_scenes
