// SPDX-License-Identifier: MIT
// Sets up a frame of one asset, where it stands, with its own lights.
#pragma once

#include <array>
#include <optional>
#include <vector>

#include "render/setup/choose.h"
#include "render/setup/frame_setup.h"

namespace dermis::setup {

inline PlacedScene alone(const Subject& subject) {
  PlacedScene scene{.name = subject.scene->name, .instances = {}, .lights = subject.scene->lights};
  scene.instances.push_back(
      {.asset = subject.scene, .sphere = subject.bounds.sphere, .profile = {}, .mix = {}});
  return scene;
}

inline FrameSetup set_up_alone(const Subject& subject, const RenderSettings& settings,
                               const std::optional<std::vector<scene::Light>>& environment_lights = {},
                               const HostSetup* host = nullptr) {
  PlacedScene scene = alone(subject);
  take_profile(scene, settings);
  return set_up(scene, std::array{&subject}, settings, {}, environment_lights, host);
}

}  // namespace dermis::setup
