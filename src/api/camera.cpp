// SPDX-License-Identifier: MIT
#include "dermis/camera.h"

#include <cmath>
#include <glm/glm.hpp>

#include "api/scene_state.h"
#include "render/setup/choose.h"
#include "render/setup/frame_setup.h"

namespace dermis {
namespace {

std::array<double, 9> rows_of(const glm::dmat3& m) {
  return {m[0][0], m[1][0], m[2][0], m[0][1], m[1][1], m[2][1], m[0][2], m[1][2], m[2][2]};
}

}  // namespace

ResolvedCamera resolved_camera(const Scene& scene, const RenderSettings& settings) {
  setup::check_settings(settings);
  const setup::PlacedScene placed = api::placed_scene(scene);
  const scene::Camera camera = setup::choose_camera(placed, settings, setup::head_spheres(placed, settings));

  const double width = settings.output.width, height = settings.output.height;
  const double aspect = camera.aspect ? double{*camera.aspect} : width / height;
  const double half_high =
      camera.orthographic ? double{camera.ymag_m} : std::tan(double{camera.fov_y_rad} / 2);
  // Ours looks along -z, +y is up.
  const glm::dmat4 world_from_camera(camera.world_from_camera);
  const glm::dmat3 ours_from_world = glm::transpose(glm::dmat3(world_from_camera));
  const glm::dmat3 theirs_from_ours(1, 0, 0, 0, -1, 0, 0, 0, -1);
  const glm::dmat3 r = theirs_from_ours * ours_from_world;
  const glm::dvec3 t_m = -(r * glm::dvec3(world_from_camera[3]));

  ResolvedCamera out{.orthographic = camera.orthographic,
                     .width = settings.output.width,
                     .height = settings.output.height,
                     .near_m = double{camera.znear_m},
                     .r = rows_of(r),
                     .t_m = {t_m.x, t_m.y, t_m.z}};
  out.k = {width / (2 * half_high * aspect),
           0,
           (1 + double{camera.axis_at.x}) / 2 * width - 0.5,
           0,
           height / (2 * half_high),
           (1 - double{camera.axis_at.y}) / 2 * height - 0.5,
           0,
           0,
           1};
  return out;
}

}  // namespace dermis
