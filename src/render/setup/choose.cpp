// SPDX-License-Identifier: MIT
#include "render/setup/choose.h"

#include <numbers>

#include "base/core/error.h"
#include "base/core/known_names.h"
#include "head/scene/framing.h"
#include "render/setup/camera_matrices.h"
#include "tissue/gaussians/json.h"
#include "tissue/gaussians/known.h"

namespace dermis::setup {

namespace {

std::vector<scene::Light> lights_of(const PlacedScene& scene, const RenderSettings& s,
                                    const HeadSpheres& spheres) {
  if (!s.lighting.placed_lights.empty()) {
    std::vector<scene::Lamp> lamps;
    for (const PlacedLight& light : s.lighting.placed_lights)
      lamps.push_back({fmt::format("light {}", lamps.size() + 1), light.azimuth_deg, light.elevation_deg,
                       glm::dvec3(light.irradiance)});
    return scene::light_rig(spheres.lit, lamps, spheres.offsets_m);
  }
  if (!s.lighting.rig_lights && !scene.lights.empty()) return scene.lights;
  const int count = s.lighting.rig_lights.value_or(2);
  return count == 0 ? std::vector<scene::Light>{} : scene::light_rig(spheres.lit, count, spheres.offsets_m);
}

}  // namespace

scene::Camera choose_camera(const PlacedScene& scene, const RenderSettings& s, const HeadSpheres& spheres) {
  const double aspect = static_cast<double>(s.output.width) / s.output.height;
  const double fov = s.camera.fov_deg.value_or(20);
  if (s.camera.matrices) return camera_of(*s.camera.matrices);
  if (s.camera.eye_m) {
    const std::array<double, 3>&eye = *s.camera.eye_m, &target = s.camera.target_m.value();
    return scene::look_at_camera({eye[0], eye[1], eye[2]}, {target[0], target[1], target[2]}, fov);
  }
  const auto [azimuth, elevation] = s.camera.orbit_deg;
  if (s.camera.distance)
    return scene::distance_camera(spheres.middle, *s.camera.distance, azimuth, elevation, fov);

  const auto with_fov = [&](scene::Camera camera) {
    if (s.camera.fov_deg) camera.fov_y_rad = static_cast<float>(fov * std::numbers::pi / 180);
    return camera;
  };

  const std::vector<scene::Camera> cameras = placed_cameras(scene);
  if (!s.camera.name.empty()) {
    std::vector<std::string> names;
    for (const scene::Camera& camera : cameras) {
      if (camera.name == s.camera.name) return with_fov(camera);
      names.push_back(camera.name);
    }
    throw input_error("", "camera.name '{}' is not in {}; {}", s.camera.name, scene.name,
                      names.empty() ? "it has no cameras" : listed_names(s.camera.name, names));
  }

  const bool orbits = s.camera.orbit_deg != std::array<double, 2>{0, 0};
  const bool one_head = scene.instances.size() == 1 && s.camera.heads == 1;
  if (!cameras.empty() && !orbits && one_head) return with_fov(cameras.front());
  return spheres.framed.size() == 1
             ? scene::framing_camera(spheres.framed.front(), aspect, azimuth, elevation, fov)
             : scene::group_camera(spheres.framed, aspect, azimuth, elevation, fov);
}

std::vector<scene::Light> choose_lights(const PlacedScene& scene, const RenderSettings& s,
                                        const HeadSpheres& spheres) {
  std::vector<scene::Light> lights = lights_of(scene, s, spheres);
  if (s.lighting.light_radius_m)
    for (scene::Light& light : lights) {
      // A directional light as if it stood where the rig does.
      const double distance =
          light.type == LightType::directional ? scene::rig_distance_radii * spheres.lit.radius_m : 1;
      light.radius = static_cast<float>(*s.lighting.light_radius_m / distance);
    }
  return lights;
}

void take_profile(PlacedScene& scene, const RenderSettings& s) {
  if (s.skin.profile.empty()) return;
  const ScatterProfile profile =
      gaussians::from_name_or_file(s.skin.profile, false, gaussians::LeastVariance::zero);
  for (PlacedInstance& instance : scene.instances) instance.profile = profile;
}

ScatterProfile choose_profile(const scene::Material& material,
                              const std::optional<ScatterProfile>& of_instance) {
  if (of_instance) return *of_instance;
  return material.skin_settings.profile.value_or(gaussians::skin_six());
}

ScatterProfile choose_profile(const scene::Material& material, const RenderSettings& s,
                              const std::optional<ScatterProfile>& of_instance,
                              gaussians::LeastVariance least) {
  if (!s.skin.profile.empty()) return gaussians::from_name_or_file(s.skin.profile, false, least);
  return choose_profile(material, of_instance);
}

}  // namespace dermis::setup
