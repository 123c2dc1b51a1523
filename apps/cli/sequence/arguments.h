// SPDX-License-Identifier: MIT
/// The arguments of `dermis sequence`.
#pragma once

#include <optional>
#include <string>

#include "cli/command.h"
#include "cli/sequence/timeline.h"

namespace dermis::cli::sequence {

struct SequenceArguments : SceneArguments {
  std::string output;  ///< a pattern of pictures, or a video
  std::string sheet;   ///< file; empty: none
  Timeline timeline;   ///< its end is that of to_s, or found when the scene is loaded
  std::optional<double> to_s;
  Motion motion;
  bool resume = false;
  DeviceArguments on;
};

/// Returns whether the clip plays. A time alone holds the pose, while something else moves.
inline bool clip_plays(const SequenceArguments& a) {
  return !a.options.time_s && (!a.options.clip.empty() || a.motion.kind == Motion::Kind::none);
}

}  // namespace dermis::cli::sequence
