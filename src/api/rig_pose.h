// SPDX-License-Identifier: MIT
/// A pose by names becomes the nodes and weights of a rig.
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "dermis/pose.h"
#include "head/scene/rig/rig.h"
#include "render/setup/placed_scene.h"

namespace dermis::api {

/// Throws InputError: see Scene::set_pose().
scene::Pose resolved(const scene::AssetData& asset, const RigPose& pose);

/// Returns what frames need of a pose; null if there is none. Throws likewise.
std::shared_ptr<const setup::PosedAsset> posed_asset(const scene::AssetData& asset,
                                                     const std::optional<RigPose>& pose);

/// Returns a clip that can be played. Throws InputError: none of this name, or a faulty one.
const scene::Clip& find_clip(const scene::AssetData& asset, const std::string& name);

std::vector<std::string> joint_names(const scene::AssetData& asset);
std::vector<std::string> morph_names(const scene::AssetData& asset);

}  // namespace dermis::api
