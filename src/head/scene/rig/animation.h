// SPDX-License-Identifier: MIT
/// Places of the nodes of an asset at a time: key frames, clips, poses. Plain numbers; what a mesh makes of a
/// pose is in its loader. Source: glTF 2.0 specification, section 3.11 and appendix C.
#pragma once

#include <cstddef>
#include <cstdint>
#include <glm/glm.hpp>
#include <glm/gtc/quaternion.hpp>
#include <optional>
#include <span>
#include <string>
#include <vector>

namespace dermis::scene {

/// Of a node against its parent: scales, then turns, then moves.
struct Transform {
  glm::dvec3 translation{0};
  glm::dquat rotation{1, 0, 0, 0};  ///< unit; w first
  glm::dvec3 scale{1};
  glm::dmat4 matrix() const;
};

enum class Interpolation : std::uint8_t {
  step,         ///< the key before
  linear,       ///< rotations along the shorter arc
  cubic_spline  ///< Hermite; each key has a tangent before it, a value, a tangent after it
};

enum class AnimatedPath : std::uint8_t { translation, rotation, scale, weights };

/// A value over time ("sampler" in glTF).
struct KeyFrames {
  Interpolation interpolation = Interpolation::linear;
  std::vector<float> times_s;  ///< at least one, each above the one before
  std::size_t size = 1;        ///< numbers of a value
  std::vector<float> values;   ///< size numbers for each key, 3 size of a cubic spline
};

/// Returns the value at a time; before the first key and after the last, theirs.
std::vector<double> value_at(const KeyFrames& keys, double seconds);
/// Returns the rotation of keys of size 4 (x y z w), of unit length.
glm::dquat rotation_at(const KeyFrames& keys, double seconds);

/// One animation of an asset: which nodes it moves, and how.
struct Clip {
  struct Channel {
    std::size_t keys = 0;  ///< index into key_frames
    std::size_t node = 0;
    AnimatedPath path = AnimatedPath::translation;
  };
  std::string name;
  std::vector<KeyFrames> key_frames;
  std::vector<Channel> channels;
  double end_s() const;  ///< time of its last key
};

/// Returns the number of the clip that is meant, the first without a name: of equal names the first, else the
/// number itself. none: there is no such clip.
std::optional<std::size_t> clip_number(std::span<const std::string> names, const std::string& name);

/// Of one node.
struct NodePose {
  Transform transform;
  std::vector<double> weights;  ///< of the morph targets of its mesh
};
using Pose = std::vector<NodePose>;  ///< by node

/// Puts the nodes that the clip moves where they stand at that time. The channels name nodes of the pose, and
/// weights have the size that the pose has.
void play(const Clip& clip, double seconds, Pose& pose);

/// Returns a pose between two of the same nodes, share 0 (a) to 1 (b): rotations along the shorter arc, all
/// else linear.
Pose blended(const Pose& a, const Pose& b, double share);

}  // namespace dermis::scene
