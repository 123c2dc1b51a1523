// SPDX-License-Identifier: MIT
/// A list of the written frames of a sequence, in a file beside them, so that a stopped run can go on.
#pragma once

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <functional>
#include <map>
#include <mutex>
#include <string>

namespace dermis::cli::sequence {

/// The file holds a fingerprint of all that the frames depend on, the device, and a line per frame with the
/// length of its file and a hash of its bytes. A frame counts as written only if its file still has these.
class Record {
 public:
  Record(std::filesystem::path path, std::uint64_t fingerprint);
  Record(const Record&) = delete;
  Record& operator=(const Record&) = delete;
  ~Record();

  /// Reads what a stopped run has left; nothing if there is no file. Throws InputError: it is of another
  /// sequence, or none of `dermis sequence`.
  void load();
  /// Returns whether the picture of this frame is whole, and that of this sequence.
  bool has(std::size_t frame, const std::filesystem::path& picture) const;

  /// Begins to write, with what was loaded. Throws InputError: the stopped run was on another device.
  void open(const std::string& device);
  /// Adds a frame whose picture has been written. Any thread may call it after open().
  void add(std::size_t frame, const std::filesystem::path& picture);
  /// Removes the file: the sequence is complete.
  void remove();

  const std::filesystem::path& path() const { return path_; }

 private:
  struct Written {
    std::uint64_t bytes = 0, hash = 0;
    bool operator==(const Written&) const = default;
  };
  static Written written(const std::filesystem::path& picture);
  static std::string line(std::size_t frame, const Written& written);

  std::filesystem::path path_;
  std::string header_;
  std::string device_;  ///< that of the file, empty: none
  std::map<std::size_t, Written> frames_;
  std::mutex mutex_;
  int file_ = -1;  ///< to append to
};

/// Removes what killed runs have left of files that were not yet whole: "NAME.PID.NUMBER.part" in this
/// folder, of a process that is gone. `is_ours` says of a NAME whether it is a file of this sequence.
void remove_unfinished(const std::filesystem::path& folder,
                       const std::function<bool(const std::string& name)>& is_ours);

}  // namespace dermis::cli::sequence
