// SPDX-License-Identifier: MIT
#include "api/rig_pose.h"

#include <algorithm>
#include <cmath>

#include "base/core/error.h"
#include "base/core/known_names.h"
#include "base/core/one_line.h"
#include "head/scene/import/limits.h"

namespace dermis::api {
namespace {

const scene::Rig& rig_of(const scene::AssetData& asset) {
  if (!asset.rig && !asset.why_no_rig.empty())
    throw input_error(
        asset.name,
        "cannot be posed once it is loaded: {}; a scene file can load it in a pose, by clip and "
        "time_s of the asset",
        asset.why_no_rig);
  if (!asset.rig) throw input_error(asset.name, "has no clips, joints or morph weights: it cannot be posed");
  return *asset.rig;
}

void require(const scene::AssetData& asset, bool holds, const std::string& member, const char* range,
             double got) {
  if (!holds) throw input_error(asset.name, "{} must be {}, got {}", member, range, got);
}

std::string joint_name(const scene::Rig& rig, std::size_t node) {
  return rig.nodes[node].name.empty() ? std::to_string(node) : rig.nodes[node].name;
}

std::string weight_name(const scene::Rig& rig, std::size_t node, std::size_t target) {
  const std::vector<std::string>& names = rig.nodes[node].weights;
  return names.empty() || names[target].empty() ? std::to_string(target) : names[target];
}

void set_weight(const scene::AssetData& asset, const MorphWeight& wanted, scene::Pose& pose) {
  const scene::Rig& rig = *asset.rig;
  require(asset, std::abs(wanted.weight) <= 100, fmt::format("pose: weight '{}'", wanted.name), "-100 to 100",
          wanted.weight);
  bool found = false;
  for (std::size_t node = 0; node < pose.size(); ++node)
    for (std::size_t target = 0; target < pose[node].weights.size(); ++target)
      if (weight_name(rig, node, target) == wanted.name) {
        pose[node].weights[target] = wanted.weight;
        found = true;
      }
  if (!found)
    throw input_error(asset.name, "has no morph weight '{}'; {}", wanted.name,
                      listed_names(wanted.name, morph_names(asset)));
}

std::size_t find_joint(const scene::AssetData& asset, const std::string& name) {
  const scene::Rig& rig = *asset.rig;
  std::size_t found = rig.nodes.size(), count = 0;
  for (std::size_t node = 0; node < rig.nodes.size(); ++node)
    if (joint_name(rig, node) == name) {
      found = node;
      ++count;
    }
  if (count == 0)
    throw input_error(asset.name, "has no joint '{}'; {}", name, listed_names(name, joint_names(asset)));
  if (count > 1) throw input_error(asset.name, "has {} joints of the name '{}'", count, name);
  if (rig.nodes[found].matrix)
    throw input_error(asset.name, "joint '{}' has a matrix in its file and cannot be moved", name);
  return found;
}

void set_joint(const scene::AssetData& asset, const JointTransform& wanted, scene::Pose& pose) {
  scene::Transform& to = pose[find_joint(asset, wanted.name)].transform;
  const auto member = [&](const char* what) {
    return fmt::format("pose: {} of joint '{}'", what, wanted.name);
  };
  const auto vector = [&](const std::array<double, 3>& v, const char* what, double most, const char* range) {
    for (const double value : v) require(asset, std::abs(value) <= most, member(what), range, value);
    return glm::dvec3(v[0], v[1], v[2]);
  };
  if (wanted.translation) to.translation = vector(*wanted.translation, "translation", 1e6, "-1e6 to 1e6");
  if (wanted.scale) to.scale = vector(*wanted.scale, "scale", 1000, "-1000 to 1000");
  if (!wanted.rotation) return;

  const auto& [x, y, z, w] = *wanted.rotation;
  for (const double value : *wanted.rotation)
    require(asset, std::abs(value) <= 1e6, member("rotation"), "finite", value);
  const glm::dquat q(w, x, y, z);
  require(asset, glm::length(q) > 1e-6, member("the length of the rotation"), "over 0", glm::length(q));
  to.rotation = glm::normalize(q);
}

const scene::Clip& clip_called(const scene::AssetData& asset, const std::string& name) {
  const std::vector<std::string>& names = asset.clips;
  const std::optional<std::size_t> number = scene::clip_number(names, name);
  if (!number) throw input_error(asset.name, "has no clip '{}'; {}", name, listed_names(name, names));
  const scene::RigClip& clip = rig_of(asset).clips.at(*number);
  if (!clip.error.empty()) throw input_error("", "{}", clip.error);
  return clip.clip;
}

scene::Pose played(const scene::AssetData& asset, const std::optional<ClipTime>& at, const char* member) {
  scene::Pose pose = asset.rig->rest;
  if (!at) return pose;
  require(asset, std::isfinite(at->seconds), fmt::format("pose: {}.seconds", member), "finite", at->seconds);
  scene::play(clip_called(asset, at->clip), at->seconds, pose);
  return pose;
}

scene::Pose made_of(const scene::AssetData& asset, const RigPose& pose) {
  rig_of(asset);
  require(asset, pose.blend >= 0 && pose.blend <= 1, "pose: blend", "0 to 1", pose.blend);
  scene::Pose result = played(asset, pose.clip, "clip");
  if (pose.second) result = scene::blended(result, played(asset, pose.second, "second"), pose.blend);
  for (const MorphWeight& weight : pose.weights) set_weight(asset, weight, result);
  for (const JointTransform& joint : pose.joints) set_joint(asset, joint, result);
  return result;
}

}  // namespace

std::vector<std::string> joint_names(const scene::AssetData& asset) {
  std::vector<std::string> names;
  for (std::size_t node = 0; asset.rig && node < asset.rig->nodes.size(); ++node)
    names.push_back(joint_name(*asset.rig, node));
  return names;
}

std::vector<std::string> morph_names(const scene::AssetData& asset) {
  std::vector<std::string> names;
  for (std::size_t node = 0; asset.rig && node < asset.rig->nodes.size(); ++node)
    for (std::size_t target = 0; target < asset.rig->rest[node].weights.size(); ++target) {
      std::string name = weight_name(*asset.rig, node, target);
      if (std::find(names.begin(), names.end(), name) == names.end()) names.push_back(std::move(name));
    }
  return names;
}

// Names of a file may hold anything.
const scene::Clip& find_clip(const scene::AssetData& asset, const std::string& name) {
  const auto found = with_one_line_errors([&] { return &clip_called(asset, name); });
  return *found;
}

scene::Pose resolved(const scene::AssetData& asset, const RigPose& pose) {
  return with_one_line_errors([&] { return made_of(asset, pose); });
}

std::shared_ptr<const setup::PosedAsset> posed_asset(const scene::AssetData& asset,
                                                     const std::optional<RigPose>& pose) {
  if (!pose) return nullptr;
  const scene::Pose nodes = resolved(asset, *pose);
  auto posed = std::make_shared<setup::PosedAsset>();
  posed->rig = with_one_line_errors([&] { return scene::posed(*asset.rig, nodes, asset.name); });
  posed->all = scene::posed_bounds(*asset.rig, posed->rig, true);
  posed->skin = scene::posed_bounds(*asset.rig, posed->rig, false);
  posed->corners_m = scene::posed_corners(*asset.rig, posed->rig);
  if (!(posed->skin.sphere.radius_m > 0)) posed->skin = posed->all;

  const glm::vec3 far = glm::max(glm::abs(posed->all.low_m), glm::abs(posed->all.high_m));
  if (!(std::max({far.x, far.y, far.z}) <= scene::largest_position_m))
    throw input_error(asset.name, "this pose puts a part of it more than {} m from the origin",
                      scene::largest_position_m);
  return posed;
}

}  // namespace dermis::api
