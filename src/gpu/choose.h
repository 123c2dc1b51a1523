// SPDX-License-Identifier: MIT
// Compares a physical device with our requirements. The comparison needs no device, so that it can be tested
// anywhere.
#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "gpu/device.h"
#include "gpu/loader.h"
#include "gpu/vulkan.h"

namespace dermis::gpu {

/// One use of a format that must work with optimal tiling.
struct FormatNeed {
  VkFormat format;
  VkFormatFeatureFlags2 features;
  const char* purpose;  ///< "half-float colour images that blend"
};
std::span<const FormatNeed> format_needs();

struct DeviceFacts {
  std::uint32_t api_version = 0;
  VkPhysicalDeviceFeatures features{};
  VkPhysicalDeviceVulkan11Features features11{};
  VkPhysicalDeviceVulkan12Features features12{};
  VkPhysicalDeviceVulkan13Features features13{};
  std::vector<std::string> extensions;
  bool graphics_and_compute_queue = false;
  std::vector<VkFormatFeatureFlags2> formats;  ///< one per entry of format_needs()
  VkSampleCountFlags colour_samples = 0, depth_samples = 0;
};

/// Returns one sentence per requirement that is not met.
std::vector<std::string> missing_of(const DeviceFacts& facts);

struct Candidate {
  VkPhysicalDevice handle = VK_NULL_HANDLE;
  std::uint32_t queue_family = 0;
  std::uint32_t timestamp_bits = 0;
  VkPhysicalDeviceType type = VK_PHYSICAL_DEVICE_TYPE_OTHER;
  bool anisotropy = false;
  DeviceInfo summary;
};
/// Examines a device; uses the given queue family, or else the first suitable one.
Candidate examine(const InstanceTable& table, VkPhysicalDevice device,
                  std::optional<std::uint32_t> family = std::nullopt);

/// Sorts usable before unusable devices; then discrete, integrated, virtual, software, other; then in the
/// driver's order.
void sort_best_first(std::vector<Candidate>& candidates);

/// Returns the selected device. Throws DeviceError: no device; no match (lists devices); a missing
/// requirement (names it).
const Candidate& choose(std::span<const Candidate> sorted, const std::string& select);

/// Returns the message for the case that Vulkan finds no device.
std::string no_driver_message();

}  // namespace dermis::gpu
