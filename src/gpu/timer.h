// SPDX-License-Identifier: MIT
// GPU timestamps by name.
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "gpu/vulkan.h"

namespace dermis::gpu {

class Device;

struct Timing {
  std::string name;
  double ms = 0;
};

/// Records pairs of timestamps into command buffers; call read() after the work has completed. Scopes with
/// equal names stay separate.
class Timer {
 public:
  Timer(Device& device, std::uint32_t max_scopes);
  Timer(const Timer&) = delete;
  Timer& operator=(const Timer&) = delete;
  ~Timer();
  void reset(VkCommandBuffer commands);  ///< before the first begin of a frame
  void begin(VkCommandBuffer commands, const std::string& name);
  void end(VkCommandBuffer commands);
  std::vector<Timing> read() const;  ///< in order of begin; 0 ms where the device has no timestamps

 private:
  struct State;
  std::unique_ptr<State> state_;
};

}  // namespace dermis::gpu
