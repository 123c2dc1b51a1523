// SPDX-License-Identifier: MIT
// Rig of the built-in head: joints of neck, head, jaw and eyes, morph targets of
// the face, and a clip.
#pragma once

#include <memory>

#include "head/builtin_head/wrap.h"
#include "head/scene/asset_data.h"
#include "head/scene/rig/rig.h"

namespace dermis::builtin_head {

/// Returns the rig of the scene, whose first primitive is the skin, node by node of the net, with the parts
/// of parts.h after it.
///
/// Joints: neck, head, jaw, left eye, right eye, at the places where they turn, axes as the world's at rest.
/// Morph targets, at weight 1: blink left, blink right, jaw open, smile, brows up, pucker.
/// Clip: "life", 6 s, which begins and ends at rest.
std::shared_ptr<const scene::Rig> make_rig(const Net& net, const scene::AssetData& scene);

}  // namespace dermis::builtin_head
