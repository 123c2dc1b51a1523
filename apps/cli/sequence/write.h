// SPDX-License-Identifier: MIT
/// Draws a sequence and writes it.
#pragma once

#include <cstddef>

#include "cli/sequence/arguments.h"
#include "cli/sequence/scene_at.h"

namespace dermis::cli::sequence {

struct Written {
  std::size_t frames = 0;   ///< that are written by now, by earlier runs as well
  bool validation = false;  ///< the validation layer has said something
};

/// Draws all frames, or those that are missing with --resume, into numbered pictures, with a record of them
/// as long as they are not complete. Ctrl-C ends it: fewer frames are written then. Throws as
/// Renderer::render() does, and InputError: a file cannot be written; the record is of another sequence.
Written write_pictures(const SequenceArguments& arguments, const Timeline& timeline, SceneSource& scenes);

/// Draws all frames into a video. After Ctrl-C there is none. Throws likewise, and if ffmpeg fails.
Written write_video(const SequenceArguments& arguments, const Timeline& timeline, SceneSource& scenes);

}  // namespace dermis::cli::sequence
