// SPDX-License-Identifier: MIT
// Sets up a frame of one asset, where it stands, with its own lights.
#pragma once

#include <optional>
#include <vector>

#include "render/setup/choose.h"
#include "render/setup/frame_setup.h"

namespace dermis::setup {

inline PlacedAsset placed(const SubjectPointer& subject) {
  return {.asset = subject->asset,
          .subject = subject,
          .sphere = subject->bounds.sphere,
          .profile = {},
          .mix = {}};
}

inline FrameSetup set_up_alone(const SubjectPointer& subject, const RenderSettings& settings,
                               const std::optional<std::vector<scene::Light>>& environment_lights = {},
                               const HostSetup* host = nullptr) {
  PlacedScene scene{
      .name = subject->asset->name, .instances = {placed(subject)}, .lights = subject->asset->lights};
  take_profile(scene, settings);
  return set_up(scene, settings, {}, environment_lights, host);
}

}  // namespace dermis::setup
