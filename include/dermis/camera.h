// SPDX-License-Identifier: MIT
/// The camera of a picture, as settings and scene choose it, in the conventions of OpenCV. For labels, and
/// for programs that project points of the scene by themselves.
#pragma once

#include <array>

#include "dermis/scene.h"
#include "dermis/settings.h"

namespace dermis {

/// A point x of the world, metres, lies at c = R x + t of the camera: +x to the right, +y down, +z ahead. It
/// is seen at pixel u = K c / c.z, of an orthographic camera at K (c.x, c.y, 1). The middle of the first
/// pixel is at 0 0, that of the last one at width - 1, height - 1. No lens distortion.
struct ResolvedCamera {
  bool orthographic = false;
  int width = 0, height = 0;  ///< of the picture, pixels
  double near_m = 0;          ///< nearer surfaces are not shown
  std::array<double, 9> k{};  ///< K, row by row; focal lengths in pixels, of an orthographic one pixels per m
  std::array<double, 9> r{};  ///< R, row by row: camera from world, a rotation
  std::array<double, 3> t_m{};
};

/// Returns the camera of a picture with these settings. Needs no device. Throws InputError: no camera of that
/// name, a setting out of range.
ResolvedCamera resolved_camera(const Scene& scene, const RenderSettings& settings);

}  // namespace dermis
