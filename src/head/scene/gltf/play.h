// SPDX-License-Identifier: MIT
// Puts the nodes of a file where one of its animations has them at a time.
#pragma once

#include "head/scene/gltf/bytes.h"
#include "head/scene/rig/animation.h"

namespace dermis::scene::gltf {

/// Reads the key frames of an animation. Channels without a node, and of properties that no mesh, joint or
/// camera here has, are left out. Throws InputError: times that do not rise, numbers that are not finite, key
/// frames of another type or number than their channel needs, a node with a matrix.
Clip read_clip(const Document& document, Bytes& bytes, std::size_t animation);

/// Returns the nodes as the file has them at rest; a node with a matrix is not in a clip, and stands still.
Pose rest_pose(const Document& document);

/// Moves the nodes of the document. Weights are those of each node then.
void take_pose(const Pose& pose, Document& document);

/// Returns the number of an animation by its name, "0", "1" ... for those that have none; empty: the first.
/// Throws InputError that lists their names, or says that there is none.
std::size_t find_animation(const Document& document, const std::string& name);

/// Names of all animations, as find_animation() takes them.
std::vector<std::string> animation_names(const Document& document);

}  // namespace dermis::scene::gltf
