// SPDX-License-Identifier: MIT
// A disk without room.
#pragma once

#include <signal.h>
#include <sys/resource.h>

namespace dermis::tests {

/// While it exists, this process cannot make any file longer than `most_bytes`: writing fails half-way, as on
/// a disk that is full. Needs no rights.
class FullDisk {
 public:
  explicit FullDisk(rlim_t most_bytes = 100) {
    ::getrlimit(RLIMIT_FSIZE, &before_);
    const rlimit full{most_bytes, before_.rlim_max};
    ignored_before_ = ::signal(SIGXFSZ, SIG_IGN);
    ::setrlimit(RLIMIT_FSIZE, &full);
  }
  ~FullDisk() {
    ::setrlimit(RLIMIT_FSIZE, &before_);
    ::signal(SIGXFSZ, ignored_before_);
  }
  FullDisk(const FullDisk&) = delete;
  FullDisk& operator=(const FullDisk&) = delete;

 private:
  rlimit before_{};
  void (*ignored_before_)(int) = nullptr;
};

}  // namespace dermis::tests
