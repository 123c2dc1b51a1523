// SPDX-License-Identifier: MIT
/// From a scene and settings to what a plan and a frame need: cameras, lights, profiles, heads. No device.
#pragma once

#include <vector>

#include "dermis/renderer.h"
#include "scene/scene.h"
#include "scene/unwrap.h"
#include "shared/scene_io.h"
#include "techniques/technique.h"

namespace dermis::api {

/// InputError for a setting out of range, with its name and range.
void check_settings(const RenderSettings& settings);

struct HeadSetup {
  glm::vec3 offset_m{0};
  std::vector<io::LightIo> lights;
  std::vector<glm::mat4> shadow_from_world;
};

struct FrameSetup {
  const techniques::Technique* technique = nullptr;
  techniques::FrameSettings plan;
  std::vector<scene::SkinMesh> skin;
  std::vector<HeadSetup> heads;  ///< far to near
  io::FrameIo frame{};
  scene::BoundingSphere sphere;
  int lights = 0, gaussians = 0;
  double d_ref = 0;  ///< sphere radii at which the mean texel density is one texel a pixel
};

FrameSetup set_up(const scene::Scene& scene, const RenderSettings& settings);

}  // namespace dermis::api
