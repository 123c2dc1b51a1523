// SPDX-License-Identifier: MIT
#include "head/scene/gltf/play.h"
#include "base/core/known_names.h"

#include <algorithm>
#include <cmath>

#include "head/scene/gltf/lenient.h"

namespace dermis::scene::gltf {
namespace {

/// Far more than a performance has; keeps an accessor without bytes from taking the memory.
constexpr std::uint64_t most_numbers = 100'000'000;

std::string place_of(std::size_t animation, std::size_t sampler) {
  return fmt::format("animations[{}].samplers[{}]", animation, sampler);
}

// Type of the key frames of a channel.
struct Shape {
  std::size_t size = 0;     ///< numbers of a value
  int components = 1;       ///< of an element of the accessor
  const char* name = "";    ///< of this type
  bool normalised = false;  ///< may be integers that stand for -1 to 1
};

Shape shape_of(AnimatedPath path, std::size_t targets) {
  switch (path) {
    case AnimatedPath::translation: return {3, 3, "VEC3", false};
    case AnimatedPath::scale: return {3, 3, "VEC3", false};
    case AnimatedPath::rotation: return {4, 4, "VEC4", true};
    case AnimatedPath::weights: break;
  }
  return {targets, 1, "SCALAR", true};
}

void check_finite(const Document& document, const std::string& place, const std::vector<float>& values) {
  const auto bad = std::find_if(values.begin(), values.end(), [](float v) { return !std::isfinite(v); });
  if (bad != values.end())
    throw input_error(document.file, "{}: number {} of its output is not finite", place,
                      bad - values.begin());
}

std::vector<float> read_times(const Document& document, Bytes& bytes, int accessor,
                              const std::string& place) {
  const Accessor& a = document.accessors[accessor];
  if (a.components() != 1 || a.component != Component::float32)
    throw input_error(document.file, "{}: input must be SCALAR of FLOAT", place);
  if (a.count > most_numbers)
    throw input_error(document.file, "{}: has {} key frames, the limit is {}", place, a.count, most_numbers);

  std::vector<float> times = bytes.floats(accessor);
  if (times.empty()) throw input_error(document.file, "{}: has no key frames", place);
  for (std::size_t i = 0; i < times.size(); ++i) {
    if (!std::isfinite(times[i]))
      throw input_error(document.file, "{}: time {} is {}, it must be finite", place, i, times[i]);
    if (i > 0 && !(times[i] >= times[i - 1]))
      throw input_error(document.file, "{}: times must not fall; {} s follows {} s", place, times[i],
                        times[i - 1]);
  }
  return times;
}

void check_rotations(const Document& document, const std::string& place, const KeyFrames& keys) {
  const bool spline = keys.interpolation == Interpolation::cubic_spline;
  for (std::size_t key = 0; key < keys.times_s.size(); ++key) {
    const float* q = &keys.values[(spline ? 3 * key + 1 : key) * 4];
    const double length = std::hypot(std::hypot(q[0], q[1]), std::hypot(q[2], q[3]));
    if (!(length > 1e-6)) throw input_error(document.file, "{}: rotation {} has no length", place, key);
  }
}

KeyFrames read_key_frames(const Document& document, Bytes& bytes, const AnimationSource::Sampler& sampler,
                          const Shape& shape, const std::string& place) {
  KeyFrames keys{.interpolation = sampler.interpolation,
                 .times_s = read_times(document, bytes, sampler.input, place),
                 .size = shape.size,
                 .values = {}};

  const Accessor& a = document.accessors[sampler.output];
  const bool whole = a.component == Component::float32 ||
                     (shape.normalised && a.normalized && a.component != Component::uint32);
  if (a.columns != 1 || a.rows != shape.components || !whole)
    throw input_error(document.file, "{}: output must be {} of FLOAT{}", place, shape.name,
                      shape.normalised ? " or normalised integers" : "");

  const std::uint64_t parts = sampler.interpolation == Interpolation::cubic_spline ? 3 : 1;
  const std::uint64_t numbers = keys.times_s.size() * parts * shape.size;
  if (numbers > most_numbers || a.count > most_numbers)
    throw input_error(document.file, "{}: has {} numbers, the limit is {}", place, numbers, most_numbers);
  if (a.count * static_cast<std::uint64_t>(a.components()) != numbers)
    throw input_error(document.file, "{}: output has {} numbers, {} key frames of {} need {}", place,
                      a.count * static_cast<std::uint64_t>(a.components()), keys.times_s.size(), shape.size,
                      numbers);
  keys.values = bytes.floats(sampler.output);
  check_finite(document, place, keys.values);
  return keys;
}

std::size_t targets_of(const Document& document, int node) {
  const int mesh = document.nodes[node].mesh;
  return mesh < 0 ? 0 : document.meshes[mesh].targets;
}

}  // namespace

Clip read_clip(const Document& document, Bytes& bytes, std::size_t animation) {
  const AnimationSource& source = document.animations[animation];
  check_fault(source.fault);
  Clip clip{.name = source.name, .key_frames = {}, .channels = {}};
  for (const AnimationSource::Channel& channel : source.channels) {
    if (channel.node < 0 || !channel.path) continue;
    const Node& node = document.nodes[channel.node];
    if (*channel.path != AnimatedPath::weights && !node.transform) {
      warn_at(document.file, node.place, "has a matrix, so its animation is left out");
      continue;
    }

    const std::string place = place_of(animation, static_cast<std::size_t>(channel.sampler));
    const Shape shape = shape_of(*channel.path, targets_of(document, channel.node));
    clip.channels.push_back({clip.key_frames.size(), static_cast<std::size_t>(channel.node), *channel.path});
    clip.key_frames.push_back(read_key_frames(
        document, bytes, source.samplers[static_cast<std::size_t>(channel.sampler)], shape, place));
    if (*channel.path == AnimatedPath::rotation) check_rotations(document, place, clip.key_frames.back());
  }
  return clip;
}

Pose rest_pose(const Document& document) {
  Pose pose;
  for (std::size_t i = 0; i < document.nodes.size(); ++i) {
    const Node& node = document.nodes[i];
    NodePose& rest = pose.emplace_back();
    rest.transform = node.transform.value_or(Transform{});
    if (node.mesh < 0) continue;
    rest.weights = node.weights.empty() ? document.meshes[node.mesh].weights : node.weights;
    rest.weights.resize(targets_of(document, static_cast<int>(i)));
  }
  return pose;
}

void take_pose(const Pose& pose, Document& document) {
  for (std::size_t i = 0; i < document.nodes.size(); ++i) {
    Node& node = document.nodes[i];
    node.weights = pose[i].weights;
    if (!node.transform) continue;
    node.transform = pose[i].transform;
    node.local = pose[i].transform.matrix();
  }
}

std::vector<std::string> animation_names(const Document& document) {
  std::vector<std::string> names;
  for (const AnimationSource& animation : document.animations) names.push_back(animation.name);
  return names;
}

std::size_t find_animation(const Document& document, const std::string& name) {
  const std::vector<std::string> names = animation_names(document);
  if (names.empty()) throw input_error(document.file, "has no animation");
  const std::optional<std::size_t> number = clip_number(names, name);
  if (!number) throw input_error(document.file, "has no animation '{}'; {}", name, listed_names(name, names));
  return *number;
}

}  // namespace dermis::scene::gltf
