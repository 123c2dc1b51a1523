// SPDX-License-Identifier: MIT
#include "cli/sequence/scene_at.h"

#include "cli/progress.h"

namespace dermis::cli::sequence {

SceneSource::SceneSource(const SceneArguments& arguments, bool plays)
    : arguments_(arguments), plays_(plays) {}

const Scene& SceneSource::scene_at(double seconds) {
  if (scene_ && (!plays_ || seconds == seconds_)) return *scene_;

  SceneArguments at = arguments_;
  if (plays_) at.options.time_s = seconds;
  if (scene_ && shows_built_in(at)) {  // takes seconds to make, and none to pose
    pose_built_in(at, *scene_);
    seconds_ = seconds;
    return *scene_;
  }

  // What there is to warn of has been said of the first one, and the line of progress is of the sequence.
  Hooks quiet{.log = [](LogLevel, const std::string&) {}, .progress = {}, .stop = &interrupted_flag()};
  scene_ = open_scene(at, scene_ ? quiet : terminal_hooks());
  seconds_ = seconds;
  return *scene_;
}

}  // namespace dermis::cli::sequence
