// SPDX-License-Identifier: MIT
#include "render/setup/placed_scene.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "base/core/error.h"
#include "head/scene/framing.h"
#include "head/scene/views.h"

namespace dermis::setup {
namespace {

scene::Camera placed(scene::Camera camera, const scene::Similarity& world_from_asset) {
  glm::mat4 rigid(world_from_asset.rotation);
  rigid[3] = glm::vec4(world_from_asset.origin_m, 1);
  camera.world_from_camera[3] = glm::vec4(glm::vec3(camera.world_from_camera[3]) * world_from_asset.scale, 1);
  camera.world_from_camera = rigid * camera.world_from_camera;
  camera.znear_m *= world_from_asset.scale;
  camera.ymag_m *= world_from_asset.scale;
  if (camera.zfar_m) *camera.zfar_m *= world_from_asset.scale;
  return camera;
}

void require_instances(const PlacedScene& scene) {
  if (scene.instances.empty()) throw input_error(scene.name, "has no instances: there is nothing to see");
}

}  // namespace

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
