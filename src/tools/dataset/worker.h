// SPDX-License-Identifier: MIT
// Draws shards.
#pragma once

#include <filesystem>
#include <functional>
#include <memory>

#include "tools/dataset/encoders.h"
#include "tools/dataset/lock.h"
#include "tools/dataset/manifest.h"
#include "tools/dataset/studio.h"

namespace dermis::dataset {

/// Where the time of the drawing thread goes, seconds.
struct Times {
  double setting = 0, drawing = 0, waiting = 0, writing = 0;
};

class Worker {
 public:
  /// Opens the device. Throws DeviceError; InputError: the lock wants another class of device.
  Worker(const Lock& lock, std::filesystem::path folder, const Options& options);

  /// Draws one shard and publishes it. Returns whether it was this worker that did. Throws InputError,
  /// DeviceError, TryAgain, Cancelled; nothing is left behind.
  bool draw(std::uint64_t shard);
  /// Likewise; a device that is lost is opened anew, once, and then TryAgain.
  bool draw_again_if_lost(std::uint64_t shard);

  const Times& times() const { return times_; }
  double encoding_s() const { return encoders_.busy_s(); }
  std::uint64_t bytes() const { return bytes_; }
  std::uint64_t heads() const { return studio_.heads_loaded(); }

 private:
  void draw_samples(Recipe::Range range, const std::string& name,
                    const std::function<void(const Encoded&)>& take);

  const Lock& lock_;
  Recipe recipe_;
  std::filesystem::path folder_;
  Hooks hooks_;
  Encoders encoders_;
  Studio studio_;
  Times times_;
  std::uint64_t bytes_ = 0;
  bool was_lost_ = false;
};

}  // namespace dermis::dataset
