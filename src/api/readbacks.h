// SPDX-License-Identifier: MIT
/// Memory that the device writes and callers read, on lease: it goes back to the renderer that made it, from
/// any thread, and serves again.
#pragma once

#include <cstdint>
#include <memory>
#include <mutex>
#include <vector>

#include "gpu/resources.h"

namespace dermis::api {

/// Of one frame, bytes; 0: not wanted.
struct ReadbackSizes {
  std::uint64_t display = 0, linear = 0, matte = 0, labels = 0;
  bool operator==(const ReadbackSizes&) const = default;
};

struct Readback {
  ReadbackSizes sizes;
  gpu::Buffer display, linear, matte, labels;  // of these sizes, or empty
};

class Readbacks {
 public:
  /// Returns one that was given back, or makes it. Of those that were given back keeps no more than a session
  /// may have in flight, and none of other sizes. For the thread of the renderer.
  std::unique_ptr<Readback> take(gpu::Device& device, const ReadbackSizes& sizes);
  /// By any thread.
  void give(std::unique_ptr<Readback> readback);

 private:
  std::mutex mutex_;
  std::vector<std::unique_ptr<Readback>> free_;
};

}  // namespace dermis::api
