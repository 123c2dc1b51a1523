// SPDX-License-Identifier: MIT
#include "render/setup/placed_scene.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

#include "base/core/error.h"
#include "head/scene/framing.h"
#include "head/scene/views.h"

namespace dermis::setup {
namespace {

constexpr double most_skew = 1e-4;  // of a rigid transform, relative

scene::Camera placed(scene::Camera camera, const Similarity& world_from_asset) {
  glm::mat4 rigid(world_from_asset.rotation);
  rigid[3] = glm::vec4(world_from_asset.origin_m, 1);
  camera.world_from_camera[3] = glm::vec4(glm::vec3(camera.world_from_camera[3]) * world_from_asset.scale, 1);
  camera.world_from_camera = rigid * camera.world_from_camera;
  camera.znear_m *= world_from_asset.scale;
  camera.ymag_m *= world_from_asset.scale;
  if (camera.zfar_m) *camera.zfar_m *= world_from_asset.scale;
  return camera;
}

// To five digits.
double rounded(double scale) {
  const double step = std::pow(10.0, std::floor(std::log10(scale)) - 5);
  const double steps = std::round(scale / step);
  // Division by a whole number keeps 1 and its likes exact.
  return step < 1 ? steps / std::round(1 / step) : steps * step;
}

// An identity stays what it is, to the bit.
glm::dmat3 orthonormal(const glm::dmat3& m) {
  const glm::dvec3 x = glm::normalize(m[0]), y = glm::normalize(m[1] - x * glm::dot(x, m[1]));
  return {x, y, glm::cross(x, y)};
}

void require_instances(const PlacedScene& scene) {
  if (scene.instances.empty()) throw input_error(scene.name, "has no instances: there is nothing to see");
}

}  // namespace

glm::vec3 Similarity::position_in_asset(const glm::vec3& p_m) const {
  return glm::transpose(rotation) * (p_m - origin_m) / scale;
}

scene::BoundingSphere Similarity::sphere(const scene::BoundingSphere& s) const {
  return {position(s.centre_m), s.radius_m * scale};
}

glm::mat4x3 Similarity::matrix() const {
  const glm::mat3 scaled = rotation * scale;
  return {scaled[0], scaled[1], scaled[2], origin_m};
}

std::optional<Similarity> similarity_of(const std::array<double, 16>& m) {
  const auto column = [&](std::size_t c) { return glm::dvec3(m[4 * c], m[4 * c + 1], m[4 * c + 2]); };
  if (!std::all_of(m.begin(), m.end(), [](double x) { return std::isfinite(x); })) return {};
  if (m[3] != 0 || m[7] != 0 || m[11] != 0 || m[15] != 1) return {};

  // The largest entry first, so that squares neither overflow nor vanish.
  const glm::dmat3 axes(column(0), column(1), column(2));
  double largest = 0;
  for (glm::length_t c = 0; c < 3; ++c)
    for (glm::length_t r = 0; r < 3; ++r) largest = std::max(largest, std::abs(axes[c][r]));
  if (!(largest > 0)) return {};

  const double determinant = glm::determinant(axes / largest);
  if (!(determinant > 0)) return {};  // flat or mirrored
  const double scale = rounded(std::cbrt(determinant) * largest);
  const glm::dmat3 rotation = axes / scale;
  const glm::dmat3 squared = glm::transpose(rotation) * rotation;
  for (glm::length_t c = 0; c < 3; ++c)
    for (glm::length_t r = 0; r < 3; ++r)
      if (!(std::abs(squared[c][r] - (c == r ? 1 : 0)) <= most_skew)) return {};

  if (scale < 1e-3 || scale > 1e3 || !(glm::length(column(3)) <= 1e9)) return {};
  return Similarity{.rotation = glm::mat3(orthonormal(rotation)),
                    .scale = static_cast<float>(scale),
                    .origin_m = glm::vec3(column(3))};
}

void check_seen(const PlacedScene& scene) {
  for (const PlacedInstance& instance : scene.instances)
    if (!(instance.asset->bounds.sphere.radius_m > 0))
      throw input_error(instance.asset->name, "has nothing to see: all its triangles lie at one point");
}

HeadSpheres head_spheres(const PlacedScene& scene, const RenderSettings& s) {
  require_instances(scene);
  HeadSpheres spheres;
  const PlacedInstance& first = scene.instances.front();
  if (scene.instances.size() == 1) {
    spheres.middle = first.world_from_asset.sphere(first.asset->bounds.sphere);
    spheres.lit = spheres.middle;
    spheres.framed = {spheres.middle};
    spheres.offsets_m = scene::head_row_offsets(s.camera.heads, spheres.middle.radius_m);
    return spheres;
  }

  const bool any_visible = std::any_of(scene.instances.begin(), scene.instances.end(),
                                       [](const PlacedInstance& instance) { return instance.visible; });
  glm::vec3 low(INFINITY), high(-INFINITY);
  for (const PlacedInstance& instance : scene.instances) {
    if (!instance.visible && any_visible) continue;
    const scene::BoundingSphere sphere = instance.world_from_asset.sphere(instance.asset->bounds.sphere);
    low = glm::min(low, sphere.centre_m - sphere.radius_m);
    high = glm::max(high, sphere.centre_m + sphere.radius_m);
    spheres.middle.radius_m = std::max(spheres.middle.radius_m, sphere.radius_m);
    spheres.framed.push_back(sphere);
  }

  // The middle of the box around them.
  spheres.middle.centre_m = spheres.lit.centre_m = (low + high) / 2.0f;
  for (const scene::BoundingSphere& sphere : spheres.framed) {
    spheres.offsets_m.push_back(sphere.centre_m - spheres.middle.centre_m);
    spheres.lit.radius_m =
        std::max(spheres.lit.radius_m, glm::length(spheres.offsets_m.back()) + sphere.radius_m);
  }

  if (spheres.lit.radius_m < static_cast<float>(scene::rig_distance_radii) * spheres.middle.radius_m)
    spheres.lit = spheres.middle;
  else
    spheres.offsets_m.clear();
  return spheres;
}

std::vector<scene::Camera> placed_cameras(const PlacedScene& scene) {
  std::vector<scene::Camera> cameras;
  for (const PlacedInstance& instance : scene.instances)
    for (std::size_t i = 0; i < instance.asset->cameras.size(); ++i) {
      scene::Camera camera = instance.asset->cameras[i];
      if (instance.posed) scene::stand_at(instance.posed->rig.cameras.at(i), camera);
      cameras.push_back(placed(camera, instance.world_from_asset));
    }
  return cameras;
}

}  // namespace dermis::setup
