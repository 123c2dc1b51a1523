// SPDX-License-Identifier: MIT
/// Poses that are edited, and clips that play.
#pragma once

#include <string>

#include "dermis/scene.h"

namespace dermis::viewer {

/// Returns the weight that a pose gives a morph target; 0 if none.
double weight_of(const RigPose& pose, const std::string& name);
void set_weight(RigPose& pose, const std::string& name, double weight);

/// Returns whether the pose leaves everything as it was loaded.
bool is_rest(const RigPose& pose);

/// Returns when a clip ends, seconds; 0 if it is faulty.
double end_of(const Asset& asset, const std::string& clip);

/// Moves the clips of all instances on by so many seconds; at the end of a clip it begins again or stops.
/// Returns whether anything has moved.
bool play_on(Scene& scene, double seconds, bool loops);

}  // namespace dermis::viewer
