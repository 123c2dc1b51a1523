// SPDX-License-Identifier: MIT
// Sets up a frame of one asset, where it stands, with its own lights.
#pragma once

#include <memory>
#include <optional>
#include <vector>

#include "render/setup/choose.h"
#include "render/setup/frame_setup.h"

namespace dermis::setup {

inline PlacedInstance placed(const std::shared_ptr<const scene::AssetData>& asset) {
  return {.asset = asset, .profile = {}, .mix = {}};
}

inline FrameSetup set_up_alone(const std::shared_ptr<const scene::AssetData>& asset,
                               const RenderSettings& settings,
                               const std::optional<std::vector<scene::Light>>& environment_lights = {},
                               const HostSetup* host = nullptr) {
  PlacedScene scene{.name = asset->name, .instances = {placed(asset)}, .lights = asset->lights};
  take_profile(scene, settings);
  return set_up(scene, settings, {}, environment_lights, host);
}

}  // namespace dermis::setup
