// SPDX-License-Identifier: MIT
#include "cli/sequence/lock.h"

#include <fcntl.h>
#include <sys/file.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cerrno>
#include <cstring>

#include "base/core/error.h"
#include "base/core/file.h"

namespace dermis::cli::sequence {
namespace {

// Returns whether the name still leads to the open file: its holder may have removed it in between.
bool is_at(const std::filesystem::path& path, int file) {
  struct stat opened {
  }, named{};
  return ::fstat(file, &opened) == 0 && ::stat(path.c_str(), &named) == 0 && opened.st_dev == named.st_dev &&
         opened.st_ino == named.st_ino;
}

}  // namespace

PatternLock::PatternLock(const std::filesystem::path& pattern) : path_(file_beside(pattern, ".lock")) {
  while (file_ < 0) {
    file_ = ::open(path_.c_str(), O_RDWR | O_CREAT | O_CLOEXEC, 0666);
    if (file_ < 0) throw input_error(path_.string(), "cannot be written: {}", std::strerror(errno));

    const bool held_by_other = ::flock(file_, LOCK_EX | LOCK_NB) != 0 && errno == EWOULDBLOCK;
    if (!held_by_other && is_at(path_, file_)) return;
    ::close(file_);
    file_ = -1;
    if (held_by_other)
      throw input_error(pattern.string(), "another `dermis sequence` is writing these pictures");
  }
}

PatternLock::~PatternLock() {
  std::error_code ignored;
  std::filesystem::remove(path_, ignored);
  ::close(file_);
}

}  // namespace dermis::cli::sequence
