// SPDX-License-Identifier: MIT
// The ray of a camera through a point of its picture.
#pragma once

#include "rays/ray_scene.h"
#include "truth/reference/settings.h"

namespace dermis::reference {

/// Returns the ray through (px, py), in pixels from the upper left corner; width and height are those of the
/// setup. Begins at the near plane of the camera.
rays::Ray camera_ray(const RenderSetup& setup, double px, double py);

}  // namespace dermis::reference
