// SPDX-License-Identifier: MIT
#include "head/scene/rig/animation.h"

#include <algorithm>
#include <charconv>
#include <glm/gtc/matrix_transform.hpp>

#include "base/core/assert.h"

namespace dermis::scene {

std::optional<std::size_t> clip_number(std::span<const std::string> names, const std::string& name) {
  const auto named = name.empty() ? names.begin() : std::find(names.begin(), names.end(), name);
  if (named != names.end()) return static_cast<std::size_t>(named - names.begin());

  std::size_t number = 0;
  const char* const end = name.data() + name.size();
  const auto read = std::from_chars(name.data(), end, number);
  if (name.empty() || read.ec != std::errc() || read.ptr != end || number >= names.size())
    return std::nullopt;
  return number;
}

namespace {

// Between two keys: the index of the first, and the share of the way to the second.
struct Between {
  std::size_t key = 0;
  double share = 0, duration_s = 0;
};

Between between(const KeyFrames& keys, double seconds) {
  const std::vector<float>& times = keys.times_s;
  const auto after = std::upper_bound(times.begin(), times.end(), seconds,
                                      [](double t, float key) { return t < double{key}; });
  if (after == times.begin()) return {};
  const auto key = static_cast<std::size_t>(after - times.begin()) - 1;
  if (after == times.end()) return {.key = key};
  const double first = double{times[key]}, duration_s = double{*after} - first;
  return {.key = key, .share = (seconds - first) / duration_s, .duration_s = duration_s};
}

// part: 0 the tangent before a key of a cubic spline, 1 its value, 2 the tangent after it.
double number(const KeyFrames& keys, std::size_t key, std::size_t i, std::size_t part = 1) {
  if (keys.interpolation != Interpolation::cubic_spline) return double{keys.values[key * keys.size + i]};
  return double{keys.values[(3 * key + part) * keys.size + i]};
}

std::vector<double> value_of(const KeyFrames& keys, std::size_t key) {
  std::vector<double> value(keys.size);
  for (std::size_t i = 0; i < keys.size; ++i) value[i] = number(keys, key, i);
  return value;
}

// glTF 2.0, appendix C.4.
double hermite(const KeyFrames& keys, const Between& at, std::size_t i) {
  const double t = at.share, t2 = t * t, t3 = t2 * t;
  return (2 * t3 - 3 * t2 + 1) * number(keys, at.key, i) +
         at.duration_s * (t3 - 2 * t2 + t) * number(keys, at.key, i, 2) +
         (3 * t2 - 2 * t3) * number(keys, at.key + 1, i) +
         at.duration_s * (t3 - t2) * number(keys, at.key + 1, i, 0);
}

// Numbers that lie on the way between two quaternions need not be one.
glm::dquat unit(const glm::dquat& q) {
  const double length = glm::length(q);
  return length > 1e-12 ? q / length : glm::dquat(1, 0, 0, 0);
}

glm::dquat quaternion(const std::vector<double>& xyzw) {
  return unit(glm::dquat(xyzw[3], xyzw[0], xyzw[1], xyzw[2]));
}

glm::dvec3 vector(const std::vector<double>& v) { return {v[0], v[1], v[2]}; }

}  // namespace

glm::dmat4 Transform::matrix() const {
  const glm::dmat4 moved = glm::translate(glm::dmat4(1), translation);
  return glm::scale(moved * glm::mat4_cast(rotation), scale);
}

std::vector<double> value_at(const KeyFrames& keys, double seconds) {
  const Between at = between(keys, seconds);
  std::vector<double> value = value_of(keys, at.key);
  if (at.share == 0 || keys.interpolation == Interpolation::step) return value;

  for (std::size_t i = 0; i < keys.size; ++i)
    value[i] = keys.interpolation == Interpolation::linear
                   ? value[i] + at.share * (number(keys, at.key + 1, i) - value[i])
                   : hermite(keys, at, i);
  return value;
}

glm::dquat rotation_at(const KeyFrames& keys, double seconds) {
  DERMIS_ASSERT_EQ(keys.size, std::size_t{4});
  const Between at = between(keys, seconds);
  if (keys.interpolation != Interpolation::linear || at.share == 0)
    return quaternion(value_at(keys, seconds));
  return glm::slerp(quaternion(value_of(keys, at.key)), quaternion(value_of(keys, at.key + 1)), at.share);
}

double Clip::end_s() const {
  double end = 0;
  for (const KeyFrames& keys : key_frames) end = std::max(end, double{keys.times_s.back()});
  return end;
}

void play(const Clip& clip, double seconds, Pose& pose) {
  for (const Clip::Channel& channel : clip.channels) {
    const KeyFrames& keys = clip.key_frames.at(channel.keys);
    NodePose& node = pose.at(channel.node);
    switch (channel.path) {
      case AnimatedPath::translation: node.transform.translation = vector(value_at(keys, seconds)); break;
      case AnimatedPath::rotation: node.transform.rotation = rotation_at(keys, seconds); break;
      case AnimatedPath::scale: node.transform.scale = vector(value_at(keys, seconds)); break;
      case AnimatedPath::weights: {
        DERMIS_ASSERT_EQ(keys.size, node.weights.size());
        node.weights = value_at(keys, seconds);
        break;
      }
    }
  }
}

Pose blended(const Pose& a, const Pose& b, double share) {
  DERMIS_ASSERT_EQ(a.size(), b.size());
  Pose pose = a;
  for (std::size_t i = 0; i < pose.size(); ++i) {
    Transform& to = pose[i].transform;
    const Transform& from = b[i].transform;
    to.translation = glm::mix(to.translation, from.translation, share);
    to.rotation = unit(glm::slerp(to.rotation, from.rotation, share));
    to.scale = glm::mix(to.scale, from.scale, share);

    DERMIS_ASSERT_EQ(pose[i].weights.size(), b[i].weights.size());
    for (std::size_t k = 0; k < pose[i].weights.size(); ++k)
      pose[i].weights[k] = glm::mix(pose[i].weights[k], b[i].weights[k], share);
  }
  return pose;
}

}  // namespace dermis::scene
