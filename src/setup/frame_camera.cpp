// SPDX-License-Identifier: MIT
#include "setup/frame_camera.h"

#include <algorithm>
#include <cmath>

#include "setup/choose.h"

namespace dermis::setup {
namespace {

constexpr int side_step = 32;  // texels

// Reversed depth without a far plane (glTF allows one; nothing here needs it): clip z = near, w = -z_view.
glm::mat4 projection(const scene::Camera& camera, double aspect) {
  glm::mat4 p(0);
  if (camera.orthographic) {
    const float far_m = camera.zfar_m.value_or(1000.0f), near_m = camera.znear_m;
    p[0][0] = 1 / (camera.ymag_m * static_cast<float>(aspect));
    p[1][1] = 1 / camera.ymag_m;
    p[2][2] = 1 / (far_m - near_m);
    p[3][2] = far_m / (far_m - near_m);
    p[3][3] = 1;
    return p;
  }
  const float f = 1 / std::tan(camera.fov_y_rad / 2);
  p[0][0] = f / static_cast<float>(aspect);
  p[1][1] = f;
  p[3][2] = camera.znear_m;
  p[2][3] = -1;
  return p;
}

// The mean density of the first skin mesh that has texture coordinates, at T_max; 0 if none has.
double texels_per_mm(const Subject& subject, const RenderSettings& s) {
  for (const scene::UnwrapDensity& density : subject.densities)
    if (density.texels_per_mm.mean > 0) return density.texels_per_mm.mean * s.quality.map_size;
  return 0;
}

// [JG08] sec. 4: the distance at which the map at T_max has one texel per pixel.
double reference_distance(const Subject& subject, const RenderSettings& s, double fov_y_rad) {
  const double density = texels_per_mm(subject, s);
  if (density <= 0) return 0;
  // pixels per mm at distance d (mm) = (height / 2) / (d tan(fov / 2)).
  const double d_mm = s.output.height / 2.0 / (density * std::tan(fov_y_rad / 2));
  return d_mm / (subject.sphere.radius_m * subject.scene->mm_per_unit);
}

// Rows of the matrix, as half spaces: -w <= x <= w, -w <= y <= w, and z <= w, which is the near plane of
// reversed depth.
std::array<glm::vec4, 5> planes_of(const glm::mat4& clip_from_world) {
  const glm::mat4 rows = glm::transpose(clip_from_world);
  std::array<glm::vec4, 5> planes{rows[3] + rows[0], rows[3] - rows[0], rows[3] + rows[1], rows[3] - rows[1],
                                  rows[3] - rows[2]};
  for (glm::vec4& plane : planes) plane /= glm::length(glm::vec3(plane));
  return planes;
}

}  // namespace

FrameCamera frame_camera(const Subject& subject, const RenderSettings& s) {
  FrameCamera camera;
  camera.scene_camera = choose_camera(*subject.scene, s, subject.sphere);
  camera.eye_m = glm::vec3(camera.scene_camera.world_from_camera[3]);
  camera.direction = -glm::normalize(glm::vec3(camera.scene_camera.world_from_camera[2]));
  camera.clip_from_world =
      projection(camera.scene_camera, static_cast<double>(s.output.width) / s.output.height) *
      glm::inverse(camera.scene_camera.world_from_camera);
  camera.planes = planes_of(camera.clip_from_world);
  if (!camera.scene_camera.orthographic)
    camera.d_ref = s.quality.d_ref.value_or(reference_distance(subject, s, camera.scene_camera.fov_y_rad));
  return camera;
}

int map_side(const Subject& subject, const RenderSettings& s, const FrameCamera& camera,
             const glm::vec3& offset_m) {
  if (!s.quality.depth || subject.skin.empty()) return s.quality.map_size;
  double needed = 1;  // of T_max
  if (camera.scene_camera.orthographic) {
    const double pixels_per_mm =
        s.output.height / (2.0 * camera.scene_camera.ymag_m * subject.scene->mm_per_unit);
    needed = pixels_per_mm / texels_per_mm(subject, s);
  } else {
    const glm::vec3 nearest =
        glm::clamp(camera.eye_m, subject.box.low + offset_m, subject.box.high + offset_m);
    const double d = glm::distance(camera.eye_m, nearest) / subject.sphere.radius_m;
    needed = d > 0 ? camera.d_ref / d : 1;
  }
  const double steps = std::ceil(std::min(needed, 1.0) * s.quality.map_size / side_step);
  return std::min(s.quality.map_size, side_step * std::max(1, static_cast<int>(steps)));
}

bool in_view(const Subject& subject, const FrameCamera& camera, const glm::vec3& offset_m) {
  const glm::vec4 centre(subject.casters.centre_m + offset_m, 1);
  return std::all_of(camera.planes.begin(), camera.planes.end(), [&](const glm::vec4& plane) {
    return glm::dot(plane, centre) > -subject.casters.radius_m;
  });
}

std::array<glm::vec4, 5> with_margin(std::array<glm::vec4, 5> planes, double margin_m) {
  for (glm::vec4& plane : planes) plane.w += static_cast<float>(margin_m);
  return planes;
}

}  // namespace dermis::setup
