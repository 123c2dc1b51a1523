// SPDX-License-Identifier: MIT
#include "viewer/window/swapchain.h"

#include <algorithm>
#include <limits>

namespace dermis::viewer {
namespace {

// Display values are what pictures hold already: no conversion may happen on the way.
VkSurfaceFormatKHR choose_format(VkPhysicalDevice physical, VkSurfaceKHR surface) {
  std::uint32_t count = 0;
  check(vkGetPhysicalDeviceSurfaceFormatsKHR(physical, surface, &count, nullptr),
        "vkGetPhysicalDeviceSurfaceFormatsKHR");
  std::vector<VkSurfaceFormatKHR> formats(count);
  check(vkGetPhysicalDeviceSurfaceFormatsKHR(physical, surface, &count, formats.data()),
        "vkGetPhysicalDeviceSurfaceFormatsKHR");
  for (const VkSurfaceFormatKHR& format : formats)
    if (format.format == VK_FORMAT_B8G8R8A8_UNORM || format.format == VK_FORMAT_R8G8B8A8_UNORM) return format;
  if (formats.empty()) throw SurfaceLost{};
  return formats.front();
}

Owned<VkSemaphore> make_semaphore(VkDevice device) {
  const VkSemaphoreCreateInfo info{VK_STRUCTURE_TYPE_SEMAPHORE_CREATE_INFO};
  VkSemaphore semaphore = VK_NULL_HANDLE;
  check(vkCreateSemaphore(device, &info, nullptr, &semaphore), "vkCreateSemaphore");
  return {device, semaphore, vkDestroySemaphore};
}

}  // namespace

Swapchain::Swapchain(const PresentDevice& device) : device_(device) {
  format_ = choose_format(device.physical(), device.surface());
  acquired_ = make_semaphore(device.handle());

  VkFenceCreateInfo fence_info{VK_STRUCTURE_TYPE_FENCE_CREATE_INFO};
  fence_info.flags = VK_FENCE_CREATE_SIGNALED_BIT;
  VkFence fence = VK_NULL_HANDLE;
  check(vkCreateFence(device.handle(), &fence_info, nullptr, &fence), "vkCreateFence");
  done_ = {device.handle(), fence, vkDestroyFence};

  VkCommandPoolCreateInfo pool_info{VK_STRUCTURE_TYPE_COMMAND_POOL_CREATE_INFO};
  pool_info.flags = VK_COMMAND_POOL_CREATE_RESET_COMMAND_BUFFER_BIT;
  pool_info.queueFamilyIndex = device.queue_family();
  VkCommandPool pool = VK_NULL_HANDLE;
  check(vkCreateCommandPool(device.handle(), &pool_info, nullptr, &pool), "vkCreateCommandPool");
  pool_ = {device.handle(), pool, vkDestroyCommandPool};

  VkCommandBufferAllocateInfo info{VK_STRUCTURE_TYPE_COMMAND_BUFFER_ALLOCATE_INFO};
  info.commandPool = pool;
  info.commandBufferCount = 1;
  check(vkAllocateCommandBuffers(device.handle(), &info, &commands_), "vkAllocateCommandBuffers");
}

void Swapchain::wait() const { check(vkDeviceWaitIdle(device_.handle()), "vkDeviceWaitIdle"); }

void Swapchain::make(VkExtent2D window) {
  wait();
  VkSurfaceCapabilitiesKHR can{};
  check(vkGetPhysicalDeviceSurfaceCapabilitiesKHR(device_.physical(), device_.surface(), &can),
        "vkGetPhysicalDeviceSurfaceCapabilitiesKHR");
  extent_ = can.currentExtent;
  if (extent_.width == std::numeric_limits<std::uint32_t>::max())
    extent_ = {std::clamp(window.width, can.minImageExtent.width, can.maxImageExtent.width),
               std::clamp(window.height, can.minImageExtent.height, can.maxImageExtent.height)};
  if (extent_.width == 0 || extent_.height == 0) return;

  VkSwapchainCreateInfoKHR info{VK_STRUCTURE_TYPE_SWAPCHAIN_CREATE_INFO_KHR};
  info.surface = device_.surface();
  info.minImageCount = can.minImageCount + 1;
  if (can.maxImageCount > 0) info.minImageCount = std::min(info.minImageCount, can.maxImageCount);
  info.imageFormat = format_.format;
  info.imageColorSpace = format_.colorSpace;
  info.imageExtent = extent_;
  info.imageArrayLayers = 1;
  info.imageUsage = VK_IMAGE_USAGE_COLOR_ATTACHMENT_BIT;
  info.preTransform = can.currentTransform;
  info.compositeAlpha = VK_COMPOSITE_ALPHA_OPAQUE_BIT_KHR;
  info.presentMode = VK_PRESENT_MODE_FIFO_KHR;
  info.clipped = VK_TRUE;
  info.oldSwapchain = chain_.get();
  VkSwapchainKHR chain = VK_NULL_HANDLE;
  check(vkCreateSwapchainKHR(device_.handle(), &info, nullptr, &chain), "vkCreateSwapchainKHR");
  views_.clear();
  chain_ = {device_.handle(), chain, vkDestroySwapchainKHR};

  std::uint32_t count = 0;
  check(vkGetSwapchainImagesKHR(device_.handle(), chain, &count, nullptr), "vkGetSwapchainImagesKHR");
  images_.resize(count);
  check(vkGetSwapchainImagesKHR(device_.handle(), chain, &count, images_.data()), "vkGetSwapchainImagesKHR");
  drawn_.clear();
  for (const VkImage image : images_) {
    VkImageViewCreateInfo view_info{VK_STRUCTURE_TYPE_IMAGE_VIEW_CREATE_INFO};
    view_info.image = image;
    view_info.viewType = VK_IMAGE_VIEW_TYPE_2D;
    view_info.format = format_.format;
    view_info.subresourceRange = {VK_IMAGE_ASPECT_COLOR_BIT, 0, 1, 0, 1};
    VkImageView view = VK_NULL_HANDLE;
    check(vkCreateImageView(device_.handle(), &view_info, nullptr, &view), "vkCreateImageView");
    views_.emplace_back(device_.handle(), view, vkDestroyImageView);
    drawn_.push_back(make_semaphore(device_.handle()));
  }
  stale_ = false;
}

void Swapchain::record_layout(VkImageLayout from, VkImageLayout to) const {
  VkImageMemoryBarrier2 barrier{VK_STRUCTURE_TYPE_IMAGE_MEMORY_BARRIER_2};
  barrier.srcStageMask = VK_PIPELINE_STAGE_2_COLOR_ATTACHMENT_OUTPUT_BIT;
  barrier.srcAccessMask = VK_ACCESS_2_COLOR_ATTACHMENT_WRITE_BIT;
  barrier.dstStageMask = VK_PIPELINE_STAGE_2_COLOR_ATTACHMENT_OUTPUT_BIT;
  barrier.dstAccessMask = VK_ACCESS_2_COLOR_ATTACHMENT_WRITE_BIT;
  barrier.oldLayout = from;
  barrier.newLayout = to;
  barrier.srcQueueFamilyIndex = barrier.dstQueueFamilyIndex = VK_QUEUE_FAMILY_IGNORED;
  barrier.image = images_.at(image_);
  barrier.subresourceRange = {VK_IMAGE_ASPECT_COLOR_BIT, 0, 1, 0, 1};
  VkDependencyInfo info{VK_STRUCTURE_TYPE_DEPENDENCY_INFO};
  info.imageMemoryBarrierCount = 1;
  info.pImageMemoryBarriers = &barrier;
  vkCmdPipelineBarrier2(commands_, &info);
}

std::optional<Swapchain::Frame> Swapchain::begin(VkExtent2D window) {
  if (window.width == 0 || window.height == 0) return {};
  if (stale_ || window.width != extent_.width || window.height != extent_.height) make(window);
  if (extent_.width == 0 || extent_.height == 0) return {};

  constexpr std::uint64_t forever = std::numeric_limits<std::uint64_t>::max();
  const VkFence done = done_.get();
  check(vkWaitForFences(device_.handle(), 1, &done, VK_TRUE, forever), "vkWaitForFences");
  // A window that is hidden may give none for as long as it is.
  constexpr std::uint64_t a_moment_ns = 100'000'000;
  const VkResult acquired = vkAcquireNextImageKHR(device_.handle(), chain_.get(), a_moment_ns,
                                                  acquired_.get(), VK_NULL_HANDLE, &image_);
  if (acquired == VK_ERROR_OUT_OF_DATE_KHR || acquired == VK_TIMEOUT || acquired == VK_NOT_READY) {
    stale_ = true;
    return {};
  }
  if (acquired == VK_SUBOPTIMAL_KHR)
    stale_ = true;
  else
    check(acquired, "vkAcquireNextImageKHR");
  check(vkResetFences(device_.handle(), 1, &done), "vkResetFences");

  VkCommandBufferBeginInfo info{VK_STRUCTURE_TYPE_COMMAND_BUFFER_BEGIN_INFO};
  info.flags = VK_COMMAND_BUFFER_USAGE_ONE_TIME_SUBMIT_BIT;
  check(vkBeginCommandBuffer(commands_, &info), "vkBeginCommandBuffer");
  record_layout(VK_IMAGE_LAYOUT_UNDEFINED, VK_IMAGE_LAYOUT_COLOR_ATTACHMENT_OPTIMAL);
  return Frame{.commands = commands_, .view = views_.at(image_).get(), .extent = extent_};
}

void Swapchain::present() {
  record_layout(VK_IMAGE_LAYOUT_COLOR_ATTACHMENT_OPTIMAL, VK_IMAGE_LAYOUT_PRESENT_SRC_KHR);
  check(vkEndCommandBuffer(commands_), "vkEndCommandBuffer");

  VkSemaphoreSubmitInfo wait{VK_STRUCTURE_TYPE_SEMAPHORE_SUBMIT_INFO};
  wait.semaphore = acquired_.get();
  wait.stageMask = VK_PIPELINE_STAGE_2_COLOR_ATTACHMENT_OUTPUT_BIT;
  VkSemaphoreSubmitInfo signal{VK_STRUCTURE_TYPE_SEMAPHORE_SUBMIT_INFO};
  signal.semaphore = drawn_.at(image_).get();
  signal.stageMask = VK_PIPELINE_STAGE_2_ALL_COMMANDS_BIT;
  VkCommandBufferSubmitInfo commands{VK_STRUCTURE_TYPE_COMMAND_BUFFER_SUBMIT_INFO};
  commands.commandBuffer = commands_;
  VkSubmitInfo2 submit{VK_STRUCTURE_TYPE_SUBMIT_INFO_2};
  submit.waitSemaphoreInfoCount = 1;
  submit.pWaitSemaphoreInfos = &wait;
  submit.commandBufferInfoCount = 1;
  submit.pCommandBufferInfos = &commands;
  submit.signalSemaphoreInfoCount = 1;
  submit.pSignalSemaphoreInfos = &signal;
  check(vkQueueSubmit2(device_.queue(), 1, &submit, done_.get()), "vkQueueSubmit2");

  const VkSwapchainKHR chain = chain_.get();
  const VkSemaphore drawn = drawn_.at(image_).get();
  VkPresentInfoKHR present{VK_STRUCTURE_TYPE_PRESENT_INFO_KHR};
  present.waitSemaphoreCount = 1;
  present.pWaitSemaphores = &drawn;
  present.swapchainCount = 1;
  present.pSwapchains = &chain;
  present.pImageIndices = &image_;
  const VkResult result = vkQueuePresentKHR(device_.queue(), &present);
  if (result == VK_SUBOPTIMAL_KHR || result == VK_ERROR_OUT_OF_DATE_KHR)
    stale_ = true;
  else
    check(result, "vkQueuePresentKHR");
}

}  // namespace dermis::viewer
