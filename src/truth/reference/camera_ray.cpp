// SPDX-License-Identifier: MIT
#include "truth/reference/camera_ray.h"

#include <cmath>

namespace dermis::reference {

rays::Ray camera_ray(const RenderSetup& setup, double px, double py) {
  const scene::Camera& camera = setup.camera;
  const double aspect =
      camera.aspect ? double{*camera.aspect} : static_cast<double>(setup.width) / setup.height;
  const double x = (2 * px / setup.width - 1 - double{camera.axis_at.x}) * aspect,
               y = 1 - 2 * py / setup.height - double{camera.axis_at.y};
  const glm::dmat4 world_from_camera(camera.world_from_camera);
  const glm::dmat3 turn(world_from_camera);
  const glm::dvec3 eye(world_from_camera[3]);

  rays::Ray ray;
  if (camera.orthographic) {
    ray.origin_m = eye + turn * glm::dvec3(x * camera.ymag_m, y * camera.ymag_m, 0);
    ray.direction = glm::normalize(turn * glm::dvec3(0, 0, -1));
    ray.t_min_m = camera.znear_m;
    return ray;
  }

  const double tan_half_y = std::tan(camera.fov_y_rad / 2.0);
  const glm::dvec3 d(x * tan_half_y, y * tan_half_y, -1);
  ray.origin_m = eye;
  ray.direction = glm::normalize(turn * d);
  // Converts the near depth to a length along the ray: d is one unit deep.
  ray.t_min_m = camera.znear_m * glm::length(d);
  return ray;
}

}  // namespace dermis::reference
