// SPDX-License-Identifier: MIT
#include "viewer/model/animation.h"

#include <algorithm>
#include <cmath>

#include "dermis/error.h"

namespace dermis::viewer {

double weight_of(const RigPose& pose, const std::string& name) {
  for (const MorphWeight& weight : pose.weights)
    if (weight.name == name) return weight.weight;
  return 0;
}

void set_weight(RigPose& pose, const std::string& name, double weight) {
  for (MorphWeight& given : pose.weights)
    if (given.name == name) {
      given.weight = weight;
      return;
    }
  pose.weights.push_back({.name = name, .weight = weight});
}

bool is_rest(const RigPose& pose) {
  return !pose.clip && !pose.second && pose.weights.empty() && pose.joints.empty();
}

double end_of(const Asset& asset, const std::string& clip) {
  try {
    return asset.clip_end_s(clip);
  } catch (const InputError&) { return 0; }
}

bool play_on(Scene& scene, double seconds, bool loops) {
  bool moved = false;
  for (const InstanceId id : scene.instances()) {
    const Instance& instance = scene.instance(id);
    if (!instance.pose || !instance.pose->clip) continue;
    RigPose pose = *instance.pose;
    const double end = end_of(instance.asset, pose.clip->clip), before = pose.clip->seconds;
    double after = before + seconds;
    if (after > end) after = loops && end > 0 ? std::fmod(after, end) : end;
    if (after == before) continue;
    pose.clip->seconds = after;
    scene.set_pose(id, pose);
    moved = true;
  }
  return moved;
}

}  // namespace dermis::viewer
