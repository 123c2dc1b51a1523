// SPDX-License-Identifier: MIT
/// The camera of a host, whatever its conventions, as one of ours.
#pragma once

#include "dermis/settings.h"
#include "head/scene/asset_data.h"

namespace dermis::setup {

/// Returns the camera. Throws InputError, which names the member of CameraMatrices and its fault: a number
/// that is none, a view that is not rigid, a projection that is neither perspective nor orthographic. Further
/// faults are a mirrored projection, a near plane behind the eye, and a view of nothing.
scene::Camera camera_of(const CameraMatrices& matrices);

/// Returns whether depth falls with the distance. Of a camera: camera_of() does not throw.
bool is_reversed(const CameraMatrices& matrices);

/// Returns a column-major matrix of a host.
glm::dmat4 matrix_of(const std::array<double, 16>& values);

/// Returns clip_from_camera * camera_from_world as the host has it, but for clip y, which grows upwards.
glm::dmat4 upright_clip_from_world(const CameraMatrices& matrices);

/// Returns upright_clip_from_world() with depth as pictures of our own have it: reversed, without a far plane
/// where it is a perspective. x, y and w are the host's to the bit. camera: camera_of() of the matrices.
glm::mat4 picture_from_world(const CameraMatrices& matrices, const scene::Camera& camera);

}  // namespace dermis::setup
