// SPDX-License-Identifier: MIT
/// The scene of a sequence at a time.
#pragma once

#include "cli/command.h"

namespace dermis::cli::sequence {

/// Loads the scene once. A clip that plays poses it for each time, as `dermis render --time` does.
class SceneSource {
 public:
  /// Loads the scene. `plays`: the clip of the arguments does, or the first one of the file if they name
  /// none. Throws as open_scene() does.
  SceneSource(const SceneArguments& arguments, bool plays);

  /// Returns the scene as it stands at this time of the clip, seconds; valid until the next call. Throws as
  /// Scene::set_pose() does.
  const Scene& scene_at(double seconds);

  /// Returns the end of what plays, seconds. Throws as api::clip_end_s() does.
  double clip_end_s() const;

 private:
  PlayingScene opened_;
  bool plays_;
};

}  // namespace dermis::cli::sequence
