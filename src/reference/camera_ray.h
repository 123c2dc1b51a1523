// SPDX-License-Identifier: MIT
// The ray of a camera through a point of its picture.
#pragma once

#include "rays/ray_scene.h"
#include "reference/settings.h"

namespace dermis::reference {

/// (px, py) in pixels from the upper left corner; width and height as in the setup. Begins at the camera's
/// near plane.
rays::Ray camera_ray(const RenderSetup& setup, double px, double py);

}  // namespace dermis::reference
