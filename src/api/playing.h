// SPDX-License-Identifier: MIT
/// A scene whose assets play a clip: how commands take --clip and --time.
#pragma once

#include <string>
#include <vector>

#include "dermis/scene.h"

namespace dermis::api {

/// An instance that stands in a clip of its asset.
struct Playing {
  InstanceId instance{};
  std::string clip;  ///< empty: the first
};

/// Returns the options with which a scene is loaded that is to play: the asset at the begin of its clip. So
/// framing, gutters and occlusion, which are found once, do not depend on the time.
SceneOptions at_begin(SceneOptions wanted);

/// Returns the instances of a scene, loaded with at_begin(wanted), that play the clip of `wanted`. These are
/// all but those that a scene file holds in a pose or at a time of their own. None if `wanted` names neither
/// clip nor time.
std::vector<Playing> playing(const Scene& scene, const SceneOptions& wanted);

/// Poses them. Throws InputError as Scene::set_pose().
void play(const std::vector<Playing>& playing, double seconds, Scene& scene);

/// Returns the time of the last key frame of what plays, seconds; of several the latest. Throws InputError:
/// nothing plays, or a clip cannot.
double clip_end_s(const Scene& scene, const std::vector<Playing>& playing);

}  // namespace dermis::api
