// SPDX-License-Identifier: MIT
/// The pictures that the window shows in turn, one frame in flight: a window that is drawn only when
/// something changes gains nothing by more.
#pragma once

#include <optional>
#include <vector>

#include "viewer/window/device.h"

namespace dermis::viewer {

class Swapchain {
 public:
  explicit Swapchain(const PresentDevice& device);
  Swapchain(const Swapchain&) = delete;
  Swapchain& operator=(const Swapchain&) = delete;

  VkFormat format() const { return format_.format; }

  struct Frame {
    VkCommandBuffer commands = VK_NULL_HANDLE;  ///< begun
    VkImageView view = VK_NULL_HANDLE;          ///< in COLOR_ATTACHMENT_OPTIMAL
    VkExtent2D extent{};
  };
  /// Begins a frame of a window of this size. None: the window has no area (minimised), or its size is just
  /// changing. Throws SurfaceLost, DeviceError.
  std::optional<Frame> begin(VkExtent2D window);
  /// Shows what begin() has given.
  void present();

  /// Waits until the device draws nothing any more.
  void wait() const;

 private:
  void make(VkExtent2D window);
  void record_layout(VkImageLayout from, VkImageLayout to) const;

  const PresentDevice& device_;
  VkSurfaceFormatKHR format_{};
  Owned<VkSwapchainKHR> chain_;
  VkExtent2D extent_{};
  std::vector<VkImage> images_;
  std::vector<Owned<VkImageView>> views_;
  std::vector<Owned<VkSemaphore>> drawn_;  ///< per image: its presentation may still wait for it
  Owned<VkSemaphore> acquired_;
  Owned<VkFence> done_;
  Owned<VkCommandPool> pool_;
  VkCommandBuffer commands_ = VK_NULL_HANDLE;
  std::uint32_t image_ = 0;
  bool stale_ = true;
};

}  // namespace dermis::viewer
