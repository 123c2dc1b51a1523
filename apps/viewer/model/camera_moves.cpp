// SPDX-License-Identifier: MIT
#include "viewer/model/camera_moves.h"

#include <algorithm>
#include <cmath>
#include <glm/glm.hpp>
#include <numbers>

#include "api/scene_state.h"
#include "api/vectors.h"
#include "render/setup/choose.h"
#include "render/setup/frame_camera.h"

namespace dermis::viewer {
namespace {

using api::array_of, api::vector_of;

constexpr double radians_per_degree = std::numbers::pi / 180;
constexpr double nearest_m = 1e-3;   // of eye and target
constexpr double steepest_deg = 89;  // the picture would turn over
constexpr double farthest_m = 1e5;

struct Axes {
  glm::dvec3 right, up, ahead;
};

Axes axes_of(const CameraPlace& place) {
  const glm::dvec3 ahead = glm::normalize(vector_of(place.target_m) - vector_of(place.eye_m));
  glm::dvec3 right = glm::cross(ahead, {0, 1, 0});
  right = glm::length(right) > 1e-6 ? glm::normalize(right) : glm::dvec3{1, 0, 0};
  return {right, glm::cross(right, ahead), ahead};
}

double distance_of(const CameraPlace& place) {
  return glm::length(vector_of(place.target_m) - vector_of(place.eye_m));
}

struct ChosenCamera {
  scene::Camera camera;
  setup::HeadSpheres spheres;
};

ChosenCamera chosen_camera(const Scene& scene, const RenderSettings& settings) {
  const setup::PlacedScene placed = api::placed_scene(scene);
  const setup::HeadSpheres spheres = setup::head_spheres(placed, settings);
  return {setup::choose_camera(placed, settings, spheres), spheres};
}

}  // namespace

HeadSphere head_sphere(const Document& document) {
  const setup::HeadSpheres spheres =
      setup::head_spheres(api::placed_scene(document.scene), document.settings);
  return {array_of(glm::dvec3(spheres.lit.centre_m)), spheres.lit.radius_m};
}

const HeadSphere& HeadSphereCache::of(const Document& document) {
  const std::vector<InstanceId> ids = document.scene.instances();
  std::vector<std::uint64_t> poses;
  for (const InstanceId id : ids) poses.push_back(document.scene.changes(id).pose);
  if (ids != ids_ || poses != poses_ || heads_ != document.settings.camera.heads) {
    sphere_ = head_sphere(document);
    ids_ = ids;
    poses_ = poses;
    heads_ = document.settings.camera.heads;
  }
  return sphere_;
}

CameraPlace camera_place(const Document& document) {
  const CameraSettings& camera = document.settings.camera;
  if (camera.eye_m && camera.target_m && !camera.matrices)
    return {*camera.eye_m, *camera.target_m, camera.fov_deg.value_or(20)};

  const auto [chosen, spheres] = chosen_camera(document.scene, document.settings);
  const glm::dvec3 eye(chosen.world_from_camera[3]);
  const glm::dvec3 ahead = -glm::normalize(glm::dvec3(chosen.world_from_camera[2]));
  const double distance = std::max(glm::dot(glm::dvec3(spheres.lit.centre_m) - eye, ahead), nearest_m);
  return {array_of(eye), array_of(eye + ahead * distance), chosen.fov_y_rad / radians_per_degree};
}

io::CameraIo drawn_camera(const Scene& scene, const RenderSettings& settings) {
  const OutputSettings& output = settings.output;
  return setup::frame_camera(chosen_camera(scene, settings).camera,
                             static_cast<double>(output.width) / output.height);
}

std::array<double, 3> point_at_depth(const io::CameraIo& camera, double u, double v, double depth_m) {
  const glm::dmat4 world_from_clip = glm::inverse(glm::dmat4(camera.clip_from_world));
  const auto on_ray = [&](double clip_z) {
    const glm::dvec4 point = world_from_clip * glm::dvec4(2 * u - 1, 1 - 2 * v, clip_z, 1);
    return glm::dvec3(point) / point.w;
  };

  const glm::dvec3 near = on_ray(1), along = on_ray(0.5) - near, ahead(camera.direction);
  const double near_m = glm::dot(near - glm::dvec3(camera.eye_m), ahead);
  return array_of(near + along * ((depth_m - near_m) / glm::dot(along, ahead)));
}

void set_camera(RenderSettings& settings, const CameraPlace& place) {
  const auto rounded = [](std::array<double, 3> point) {
    for (double& x : point) x = std::round(std::clamp(x, -farthest_m, farthest_m) * 1e6) / 1e6;
    return point;
  };
  CameraSettings& camera = settings.camera;
  camera.name.clear();
  camera.distance.reset();
  camera.orbit_deg = {0, 0};
  camera.matrices.reset();
  camera.eye_m = rounded(place.eye_m);
  camera.target_m = rounded(place.target_m);
  camera.fov_deg = std::round(place.fov_deg * 1e4) / 1e4;
}

CameraPlace orbited(const CameraPlace& place, double azimuth_deg, double elevation_deg) {
  const glm::dvec3 target = vector_of(place.target_m), from = vector_of(place.eye_m) - target;
  const double distance = std::max(glm::length(from), nearest_m);
  double azimuth = std::atan2(from.x, from.z) + azimuth_deg * radians_per_degree;
  double elevation = std::asin(std::clamp(from.y / distance, -1.0, 1.0));
  elevation = std::clamp(elevation + elevation_deg * radians_per_degree, -steepest_deg * radians_per_degree,
                         steepest_deg * radians_per_degree);

  const glm::dvec3 direction{std::cos(elevation) * std::sin(azimuth), std::sin(elevation),
                             std::cos(elevation) * std::cos(azimuth)};
  return {array_of(target + direction * distance), place.target_m, place.fov_deg};
}

CameraPlace flown(const CameraPlace& place, const std::array<double, 3>& by_m) {
  const Axes axes = axes_of(place);
  const glm::dvec3 by = axes.right * by_m[0] + axes.up * by_m[1] + axes.ahead * by_m[2];
  return {array_of(vector_of(place.eye_m) + by), array_of(vector_of(place.target_m) + by), place.fov_deg};
}

CameraPlace panned(const CameraPlace& place, double right, double up) {
  const double height_m = 2 * distance_of(place) * std::tan(place.fov_deg * radians_per_degree / 2);
  return flown(place, {right * height_m, up * height_m, 0});
}

CameraPlace dollied(const CameraPlace& place, double factor) {
  const glm::dvec3 target = vector_of(place.target_m), from = vector_of(place.eye_m) - target;
  const double distance = std::clamp(glm::length(from) * factor, nearest_m, farthest_m);
  return {array_of(target + glm::normalize(from) * distance), place.target_m, place.fov_deg};
}

CameraPlace framed(const CameraPlace& place, const HeadSphere& sphere, double aspect) {
  const glm::dvec3 ahead = axes_of(place).ahead, centre = vector_of(sphere.centre_m);
  // As framing has it: the outline of the sphere fills 95 % of the smaller side.
  constexpr double fill = 0.95;
  const double half = std::tan(place.fov_deg * radians_per_degree / 2) * std::min(1.0, aspect) * fill;
  const double distance = sphere.radius_m / std::sin(std::atan(half));
  return {array_of(centre - ahead * distance), sphere.centre_m, place.fov_deg};
}

std::vector<std::string> camera_names(const Scene& scene) {
  std::vector<std::string> names;
  for (const scene::Camera& camera : setup::placed_cameras(api::placed_scene(scene)))
    names.push_back(camera.name);
  return names;
}

}  // namespace dermis::viewer
