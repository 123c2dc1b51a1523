// SPDX-License-Identifier: MIT
/// Where the camera stands, and what of the heads it needs: how large their light maps, which of them at all.
#pragma once

#include <array>
#include <cstdint>
#include <glm/glm.hpp>
#include <vector>

#include "dermis/renderer.h"
#include "setup/subject.h"

namespace dermis::setup {

struct FrameCamera {
  scene::Camera scene_camera;  ///< one of the scene, or the framing one
  glm::mat4 clip_from_world{1};
  glm::vec3 eye_m{0};
  glm::vec3 direction{0, 0, -1};  ///< unit, where it looks
  /// World space, left, right, bottom, top, near: dot(xyz, position_m) + w is the distance inside, metres.
  std::array<glm::vec4, 5> planes{};
  double d_ref = 0;  ///< sphere radii at which the map at T_max has one texel per pixel; 0 if orthographic
};

/// InputError: no such camera (lists those of the scene).
FrameCamera frame_camera(const Subject& subject, const RenderSettings& settings);

/// [JG08] sec. 4: T of a head, min(d_ref / d, 1) T_max rounded up to 32 texels, d from the eye to the nearest
/// point of the head's box (the paper takes the nearest vertex; a point that is never farther keeps the map
/// from being too small). Orthographic: pixels per mm over texels per mm in place of d_ref / d.
int map_side(const Subject& subject, const RenderSettings& settings, const FrameCamera& camera,
             const glm::vec3& offset_m);

/// Whether any part of the head may lie in the picture: its sphere against the planes.
bool in_view(const Subject& subject, const FrameCamera& camera, const glm::vec3& offset_m);

/// The planes moved outwards by the margin: [JG08] sec. 5 clips at the view itself (margin 0).
std::array<glm::vec4, 5> with_margin(std::array<glm::vec4, 5> planes, double margin_m);

}  // namespace dermis::setup
