// SPDX-License-Identifier: MIT
// Keeps of a file what poses it again: see head/scene/rig/rig.h.
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "head/scene/gltf/finish.h"
#include "head/scene/gltf/place.h"
#include "head/scene/rig/rig.h"

namespace dermis::scene::gltf {

/// Returns whether the file has anything to pose: animations, skins or morph targets.
bool can_move(const Document& document);

/// Returns why a rig of the file would be too large to be kept; empty if it is not.
std::string too_large_to_pose(const Document& document);

/// Returns the rig of the scene. `document`: in the pose in which the scene was placed. `moving`: one for
/// each of scene.primitives, which are complete: pose 0 of the rig has the vertices that they have.
/// `own_tangents`: by primitive, they are those of the file. `views`: of the cameras and lights of the scene.
std::shared_ptr<const Rig> read_rig(const Document& document, Bytes& bytes, double unit_scale,
                                    const std::vector<MovingMesh>& moving,
                                    const std::vector<bool>& own_tangents, const ViewNodes& views,
                                    const AssetData& scene);

}  // namespace dermis::scene::gltf
