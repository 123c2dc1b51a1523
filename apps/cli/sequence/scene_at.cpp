// SPDX-License-Identifier: MIT
#include "cli/sequence/scene_at.h"

namespace dermis::cli::sequence {
namespace {

PlayingScene opened(SceneArguments arguments, bool plays) {
  if (plays) arguments.options.time_s = 0;
  return open_playing_scene(arguments);
}

}  // namespace

SceneSource::SceneSource(const SceneArguments& arguments, bool plays)
    : opened_(opened(arguments, plays)), plays_(plays) {
  if (!plays) api::play(opened_.playing, arguments.options.time_s.value_or(0), opened_.scene);
}

const Scene& SceneSource::scene_at(double seconds) {
  if (plays_) api::play(opened_.playing, seconds, opened_.scene);
  return opened_.scene;
}

double SceneSource::clip_end_s() const { return api::clip_end_s(opened_.scene, opened_.playing); }

}  // namespace dermis::cli::sequence
