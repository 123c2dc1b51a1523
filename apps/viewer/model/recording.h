// SPDX-License-Identifier: MIT
/// Sequences of what the window shows, drawn by `dermis sequence`.
#pragma once

#include <string>
#include <vector>

#include "dermis/hooks.h"
#include "viewer/model/document.h"

namespace dermis::viewer {

enum class RecordedMotion { turntable, lamp, clip };

/// Options of a recording. Ranges are those of `dermis sequence`, which refuses what lies outside.
struct Recording {
  RecordedMotion motion = RecordedMotion::turntable;
  double fps = 30;
  double seconds = 4;  ///< of a full turn; a clip is as long as it is
  bool video = false;  ///< .mp4, else numbered pictures
};

/// The clip that plays: of the first instance that is posed by one; empty: none is.
std::string clip_of(const Scene& scene);

/// The document as it stands when a clip of it is played by a sequence: what that clip poses is at rest.
Document ready_for_clip(Document document, const std::string& clip);

/// Returns `dermis sequence` and its words, without the program. The camera of a turntable frames the head at
/// the height from which it is seen now. `name`: what files begin with.
std::vector<std::string> sequence_words(const Recording& recording,
                                        const std::vector<std::string>& scene_words, const Document& document,
                                        const std::string& device, const std::string& name);

/// Runs the `dermis` beside this program with these words, until it ends or a hook ends it. Returns what it
/// says last. Throws InputError with that, where it fails; Cancelled.
std::string record(const std::vector<std::string>& words, const Hooks& hooks);

}  // namespace dermis::viewer
