// SPDX-License-Identifier: MIT
/// The scene of a sequence at a time.
#pragma once

#include <optional>

#include "cli/command.h"

namespace dermis::cli::sequence {

/// A clip that plays is taken anew from its file for each time, as `dermis render --time` takes it; without
/// one the scene is loaded once.
class SceneSource {
 public:
  /// `plays`: the clip of the arguments does, or the first one of the file if they name none.
  SceneSource(const SceneArguments& arguments, bool plays);

  /// Returns the scene as it stands at this time of the clip, seconds; valid until the next call. Throws as
  /// open_scene() does.
  const Scene& scene_at(double seconds);

 private:
  const SceneArguments& arguments_;
  bool plays_;
  double seconds_ = 0;  ///< of scene_
  std::optional<Scene> scene_;
};

}  // namespace dermis::cli::sequence
