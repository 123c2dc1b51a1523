// SPDX-License-Identifier: MIT
// What we need of a physical device, held against what it has. The comparison is pure, so that it is tested
// without such devices.
#pragma once

#include <volk.h>

#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "gpu/device.h"
#include "gpu/loader.h"

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
  std::vector<VkFormatFeatureFlags2> formats;  ///< for each of format_needs()
  VkSampleCountFlags colour_samples = 0, depth_samples = 0;
};

/// One sentence for each requirement that is not met.
std::vector<std::string> missing_of(const DeviceFacts& facts);

struct Candidate {
  VkPhysicalDevice handle = VK_NULL_HANDLE;
  std::uint32_t queue_family = 0;
  std::uint32_t timestamp_bits = 0;
  VkPhysicalDeviceType type = VK_PHYSICAL_DEVICE_TYPE_OTHER;
  bool anisotropy = false;
  DeviceSummary summary;
};
/// The queue family is the given one, or else the first that serves.
Candidate examine(const InstanceTable& table, VkPhysicalDevice device,
                  std::optional<std::uint32_t> family = std::nullopt);

/// Usable before unusable; then discrete, integrated, virtual, software, other; else in the driver's order.
void sort_best_first(std::vector<Candidate>& candidates);

/// DeviceError: none there, none such (lists them), or the one chosen lacks something (says what).
const Candidate& choose(std::span<const Candidate> sorted, const std::string& select);

/// What to say when Vulkan finds no device at all.
std::string no_driver_message();

}  // namespace dermis::gpu
