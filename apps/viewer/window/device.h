// SPDX-License-Identifier: MIT
/// The device that shows the window: instance, surface, one queue that draws and presents. The library
/// renders heads on its own device; the two share nothing but pixels.
#pragma once

#include <GLFW/glfw3.h>

#include <cstddef>
#include <string>
#include <vector>

#include "viewer/window/owned.h"

namespace dermis::viewer {

struct DeviceImage {
  Owned<VkDeviceMemory> memory;
  Owned<VkImage> image;
  Owned<VkImageView> view;
  VkExtent2D extent{};
};

/// Memory that the processor sees at `mapped`, coherently.
struct HostBuffer {
  Owned<VkDeviceMemory> memory;
  Owned<VkBuffer> buffer;
  VkDeviceSize bytes = 0;
  std::byte* mapped = nullptr;
};

class PresentDevice {
 public:
  /// Throws DeviceError: no device of Vulkan 1.3 can show pictures in this window. `validate`: under the
  /// validation layer, where it is installed; its messages are added to `said`, those of the destruction,
  /// too.
  PresentDevice(GLFWwindow* window, bool validate, std::vector<std::string>& said);
  PresentDevice(const PresentDevice&) = delete;
  PresentDevice& operator=(const PresentDevice&) = delete;

  VkDevice handle() const { return vk_.device; }
  VkPhysicalDevice physical() const { return physical_; }
  VkSurfaceKHR surface() const { return vk_.surface; }
  VkQueue queue() const { return queue_; }
  std::uint32_t queue_family() const { return queue_family_; }
  bool is_software() const { return is_software_; }

  /// Returns when the device draws nothing any more; a lost one does not.
  void wait_idle() const { vkDeviceWaitIdle(vk_.device); }

  DeviceImage make_image(VkExtent2D extent) const;  ///< RGBA8, sampled, filled by copies
  HostBuffer make_buffer(VkDeviceSize bytes, VkBufferUsageFlags usage) const;

 private:
  /// Handles that all else depends on: destroyed last, also where a constructor throws.
  struct Handles {
    VkInstance instance = VK_NULL_HANDLE;
    VkDebugUtilsMessengerEXT messenger = VK_NULL_HANDLE;
    VkSurfaceKHR surface = VK_NULL_HANDLE;
    VkDevice device = VK_NULL_HANDLE;
    ~Handles();
  };
  void make_instance(bool validate, std::vector<std::string>& said);
  bool try_device(VkPhysicalDevice physical);
  Owned<VkDeviceMemory> allocate(const VkMemoryRequirements& needs, VkMemoryPropertyFlags properties) const;

  Handles vk_;
  VkPhysicalDevice physical_ = VK_NULL_HANDLE;
  VkPhysicalDeviceMemoryProperties memory_{};
  VkQueue queue_ = VK_NULL_HANDLE;
  std::uint32_t queue_family_ = 0;
  bool is_software_ = false;
};

}  // namespace dermis::viewer
