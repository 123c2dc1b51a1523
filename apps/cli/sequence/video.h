// SPDX-License-Identifier: MIT
/// Videos, made by the program ffmpeg from frames that are piped to it.
#pragma once

#include <sys/types.h>

#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

#include "dermis/renderer.h"

namespace dermis::cli::sequence {

/// Returns whether this is the name of a video: .mp4, .webm or .webp.
bool is_video(const std::filesystem::path& path);

/// Throws InputError: no ffmpeg on the path (says what to do), a size that the format does not have.
void check_video(const std::filesystem::path& path, int width, int height);

/// The file has another name until it is whole; without finish() nothing is left of it.
class Video {
 public:
  /// Starts ffmpeg. Sizes in pixels, `fps`: frames per second. Throws InputError as check_video() does, and
  /// if it cannot be started.
  Video(std::filesystem::path path, int width, int height, double fps);
  ~Video();
  Video(const Video&) = delete;
  Video& operator=(const Video&) = delete;

  /// Adds the next frame, its display values. Throws InputError with what ffmpeg says, if it has ended.
  void add(const Picture& picture);
  /// Waits for ffmpeg and gives the file its name. Throws InputError likewise.
  void finish();

 private:
  [[noreturn]] void fail();
  int wait();  ///< returns the status of waitpid(), once
  void close_pipe();

  std::filesystem::path path_, unfinished_;
  pid_t process_ = -1;
  int pipe_ = -1;      ///< its standard input
  int messages_ = -1;  ///< a file without a name: its standard error
  std::vector<std::uint8_t> rgb_;
};

}  // namespace dermis::cli::sequence
