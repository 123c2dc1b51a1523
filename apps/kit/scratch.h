// SPDX-License-Identifier: MIT
// A folder for what is needed while the kit runs.
#pragma once

#include <filesystem>

namespace dermis::kit {

/// A folder beside the results, so that whatever a measurement writes takes room where the results will; gone
/// at the end. The next run removes the files of a killed one: a run holds a lock as long as it lives.
class Scratch {
 public:
  /// Makes `results` if it is not there. Throws InputError: it cannot be written to, or has less than
  /// least_free_mb of room.
  explicit Scratch(const std::filesystem::path& results);
  Scratch(const Scratch&) = delete;
  Scratch& operator=(const Scratch&) = delete;
  ~Scratch();

  const std::filesystem::path& path() const { return path_; }

 private:
  std::filesystem::path path_;
  int lock_ = -1;
};

inline constexpr double least_free_mb = 100;

}  // namespace dermis::kit
