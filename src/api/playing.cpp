// SPDX-License-Identifier: MIT
#include "api/playing.h"

#include <algorithm>

#include "api/asset_state.h"
#include "base/core/error.h"

namespace dermis::api {

SceneOptions at_begin(SceneOptions wanted) {
  // A time alone is one of the first clip.
  if (wanted.time_s) wanted.time_s = wanted.clip.empty() ? std::optional(0.0) : std::nullopt;
  return wanted;
}

std::vector<Playing> playing(const Scene& scene, const SceneOptions& wanted) {
  std::vector<Playing> found;
  if (wanted.clip.empty() && !wanted.time_s) return found;
  for (const InstanceId id : scene.instances()) {
    const Instance& instance = scene.instance(id);
    const std::optional<Asset::State::Source>& source = Asset::State::source_of(instance.asset);
    if (instance.pose || (source && source->holds_time)) continue;
    const bool is_of_file = source && !source->file.empty();
    found.push_back({.instance = id, .clip = is_of_file ? source->options.clip : wanted.clip});
  }
  return found;
}

void play(const std::vector<Playing>& playing, double seconds, Scene& scene) {
  for (const Playing& one : playing) scene.pose(one.instance, one.clip, seconds);
}

double clip_end_s(const Scene& scene, const std::vector<Playing>& playing) {
  if (playing.empty())
    throw input_error(scene.name(), "has nothing that plays a clip: all stand in a pose of their own");
  double end_s = 0;
  for (const Playing& one : playing)
    end_s = std::max(end_s, scene.instance(one.instance).asset.clip_end_s(one.clip));
  return end_s;
}

}  // namespace dermis::api
