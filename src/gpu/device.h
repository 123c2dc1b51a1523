// SPDX-License-Identifier: MIT
// A Vulkan 1.3 device, ours or a host's. Owns only what it created: a host keeps its instance, device and
// queue. Our function pointers are per device (a DeviceTable), never global.
#pragma once

#include <array>
#include <cstdint>
#include <filesystem>
#include <functional>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "dermis/device_info.h"
#include "dermis/vulkan.h"
#include "gpu/vulkan.h"

namespace dermis::gpu {

using vulkan::RequiredFeatures;

/// As dermis::list_devices().
std::vector<DeviceInfo> list_devices();

struct DeviceLimits {
  std::uint32_t max_image_side = 0;  ///< texels, 2D
  std::uint32_t max_array_layers = 0;
  std::uint64_t max_buffer_bytes = 0;
  std::uint64_t max_storage_buffer_bytes = 0;
  std::uint64_t max_texel_buffer_texels = 0;
  std::array<std::uint32_t, 3> max_workgroups{};  ///< per dispatch and axis
  std::uint32_t max_workgroup_threads = 0;
  float max_anisotropy = 1;  ///< 1: none
  std::uint32_t max_push_bytes = 0;
  std::uint32_t max_clip_distances = 0;
  float timestamp_period_ns = 1;
  std::uint64_t timestamp_mask = 0;  ///< valid bits; 0: none
  bool timestamps = false;
  bool software = false;  ///< timestamps between raster passes are not reliable there
};

/// Requests to a device so far. A steady frame adds submissions alone.
struct DeviceCounters {
  std::uint64_t allocations = 0;  ///< of memory from the driver
  std::uint64_t buffers = 0, images = 0, pipelines = 0;
  std::uint64_t submissions = 0;
  std::uint64_t waits = 0;       ///< for a submission that had not completed
  std::uint64_t idle_waits = 0;  ///< of these, for all that was submitted
};

class Buffer;
class Texture;
struct BufferDesc;
struct TextureDesc;
class MemoryPool;

/// Device, queue, memory, and the objects that wait for the GPU. One thread at a time records and submits.
class Device {
 public:
  struct Options {
    /// "best", an index of list_devices(), or a part of a name (case-insensitive)
    std::string select = "best";
    /// validation layer with synchronization validation; messages are counted and kept
    bool validate = false;
  };

  /// Throws DeviceError: no driver; no match (lists devices); a missing requirement (names it); validation
  /// layer not installed.
  explicit Device(const Options& options);
  /// Uses a host's. Throws InputError: a handle is null.
  explicit Device(const vulkan::Host& host);
  Device(const Device&) = delete;
  Device& operator=(const Device&) = delete;
  ~Device();  ///< waits for all submissions of this object

  VkDevice handle() const;
  const DeviceTable& vk() const;
  const DeviceInfo& summary() const;
  const DeviceLimits& limits() const;
  bool format_supports(VkFormat format, VkFormatFeatureFlags features) const;  ///< optimal tiling
  /// Returns the sizes and sample counts of 2D images of this format and usage; nothing if they are not
  /// supported.
  std::optional<VkImageFormatProperties> image_format_properties(VkFormat format,
                                                                 VkImageUsageFlags usage) const;
  const VkPhysicalDeviceProperties& properties() const;

  /// Starts a primary command buffer for one use.
  VkCommandBuffer begin();
  /// Ends and submits it; returns the serial that wait() takes.
  std::uint64_t submit(VkCommandBuffer commands);
  /// Frees commands that will not be submitted (recording them failed).
  void discard(VkCommandBuffer commands);
  void wait(std::uint64_t serial);  ///< DeviceError if the device is lost
  bool has_completed(std::uint64_t serial) const;
  /// Begins, records, submits and waits.
  void run(const std::function<void(VkCommandBuffer)>& record);

  /// Says that commands of the host's frame `recorded` are about to be recorded, and that the device has
  /// finished those of all frames up to `finished`: frees what only these needed.
  void begin_host_frame(std::uint64_t recorded, std::uint64_t finished);
  /// Calls `free` once all work recorded so far has completed, the host's frames included (now, if nothing is
  /// in flight).
  void retire(std::function<void()> free);

  DeviceCounters& counters();

  MemoryPool& memory();
  std::uint64_t image_bytes() const;  ///< currently allocated for textures
  std::uint64_t buffer_bytes() const;
  std::uint64_t peak_bytes() const;

  /// Returns the messages of the validation layer (errors and warnings), in order. Empty if not validating.
  const std::vector<std::string>& validation_messages() const;

  /// These do nothing without debug utils.
  void set_name(VkObjectType type, std::uint64_t handle, const std::string& name) const;
  void begin_label(VkCommandBuffer commands, const std::string& name) const;
  void end_label(VkCommandBuffer commands) const;

 private:
  struct State;
  std::unique_ptr<State> state_;
};

/// Throws DeviceError that names the call and the result ("vkCreateImage: out of device memory; needed ...").
void check(VkResult result, std::string_view what);

}  // namespace dermis::gpu
