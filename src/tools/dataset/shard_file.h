// SPDX-License-Identifier: MIT
// A file that several workers may write at a time, and that appears once, whole.
//
// It is written as NAME.HOST.PID under a lock (flock) and published by link(), which fails if NAME is there.
// Files of workers that died are unlocked: those of this machine are removed, those of others after an hour.
#pragma once

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "tools/dataset/sha256.h"

namespace dermis::dataset {

/// Returns the name of this machine; empty: it has none.
std::string host_name();

/// "SHARD.HOST.PID" for another file beside it.
std::filesystem::path temporary_of(const std::filesystem::path& path);

/// Returns the temporary files of `path` that workers hold now; `removes`: removes those that nobody holds.
std::vector<std::filesystem::path> held_temporaries(const std::filesystem::path& path, bool removes);

class ShardFile {
 public:
  /// Throws TryAgain: the file cannot be made.
  explicit ShardFile(const std::filesystem::path& path);
  /// Removes what was not published.
  ~ShardFile();
  ShardFile(const ShardFile&) = delete;
  ShardFile& operator=(const ShardFile&) = delete;

  /// Throws TryAgain: the disk is full, or takes nothing more.
  void write(std::span<const std::byte> bytes);
  std::uint64_t bytes() const { return bytes_; }

  /// Ends the file, whose hash is then known, and brings it to the disk. Throws as write().
  std::string finish();

  enum class Published { by_us, was_there };
  /// Publishes the file and, beside it, what `beside` is to hold: after a file that is there without it, too.
  /// Throws TryAgain.
  Published publish(const std::filesystem::path& beside, std::string_view text);

 private:
  std::filesystem::path path_, temporary_;
  int file_;
  std::uint64_t bytes_ = 0;
  Sha256 hash_;
  std::string digest_;
};

}  // namespace dermis::dataset
