// SPDX-License-Identifier: MIT
/// Keeps two runs from writing the same pictures.
#pragma once

#include <filesystem>

namespace dermis::cli::sequence {

/// Holds the file PATTERN.lock, which goes with it. The system lets go of it, too, if the process is killed.
class PatternLock {
 public:
  /// Throws InputError: another process holds it. Where a file system knows no locks nothing is held.
  explicit PatternLock(const std::filesystem::path& pattern);
  PatternLock(const PatternLock&) = delete;
  PatternLock& operator=(const PatternLock&) = delete;
  ~PatternLock();

 private:
  std::filesystem::path path_;
  int file_ = -1;
};

}  // namespace dermis::cli::sequence
