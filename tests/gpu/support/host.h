// SPDX-License-Identifier: MIT
// A program with a Vulkan device, images and command buffers of its own, as an engine has them.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <span>
#include <string>
#include <vector>

#include "dermis/vulkan.h"
#include "gpu/loader.h"
#include "gpu/vulkan.h"

namespace dermis::tests {

/// An image, one view of all of it, and the layout that Host left it in.
struct HostImage {
  VkImage handle = VK_NULL_HANDLE;
  VkDeviceMemory memory = VK_NULL_HANDLE;
  VkImageView view = VK_NULL_HANDLE;
  VkFormat format = VK_FORMAT_UNDEFINED;
  VkExtent2D extent{};
  VkImageLayout layout = VK_IMAGE_LAYOUT_UNDEFINED;
};

struct HostBuffer {
  VkBuffer handle = VK_NULL_HANDLE;
  VkDeviceMemory memory = VK_NULL_HANDLE;
  std::byte* mapped = nullptr;
  std::uint64_t bytes = 0;
};

/// The validation layer watches it, where it is installed. Frees what it made when it is destroyed.
class Host {
 public:
  Host();
  Host(const Host&) = delete;
  Host& operator=(const Host&) = delete;
  ~Host();

  vulkan::Host vulkan() const;
  const std::vector<std::string>& messages() const { return messages_; }
  const gpu::DeviceTable& vk() const { return vk_; }

  HostImage image(VkFormat format, VkExtent2D extent, std::uint32_t samples, VkImageUsageFlags usage);
  HostBuffer buffer(std::uint64_t bytes, VkBufferUsageFlags usage);

  /// Records, submits and waits.
  void run(const std::function<void(VkCommandBuffer)>& record);
  void transition(VkCommandBuffer commands, HostImage& image, VkImageLayout layout);
  /// Draws nothing into targets but a clear of this part of them.
  void clear(VkCommandBuffer commands, const HostImage* colour, std::array<float, 4> value,
             const HostImage* depth, float depth_value, VkRect2D area);
  /// Averages the samples of one image into another.
  void resolve(VkCommandBuffer commands, const HostImage& from, const HostImage& to);
  /// Returns what an image of one sample holds, tightly packed.
  std::vector<std::byte> read(HostImage& image);

 private:
  void make_instance();
  void make_device();
  VkDeviceMemory allocate(const VkMemoryRequirements& needs, VkMemoryPropertyFlags properties);
  template <class F>
  void load(F& function, const char* name) const;

  PFN_vkGetInstanceProcAddr get_ = nullptr;
  VkInstance instance_ = VK_NULL_HANDLE;
  VkDebugUtilsMessengerEXT messenger_ = VK_NULL_HANDLE;
  VkPhysicalDevice physical_ = VK_NULL_HANDLE;
  VkDevice device_ = VK_NULL_HANDLE;
  bool sampler_anisotropy_ = false;
  VkQueue queue_ = VK_NULL_HANDLE;
  VkCommandPool pool_ = VK_NULL_HANDLE;
  VkPhysicalDeviceMemoryProperties memory_{};
  gpu::DeviceTable vk_{};
  std::vector<HostImage> images_;
  std::vector<HostBuffer> buffers_;
  std::vector<std::string> messages_;
};

}  // namespace dermis::tests
