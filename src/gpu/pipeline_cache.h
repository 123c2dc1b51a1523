// SPDX-License-Identifier: MIT
// Stores driver code in a file between runs. Drivers check only their own header, and crash on damaged data
// behind it. So the file is one of base/core/cache.h, with a checksum, and begins with our own header that
// identifies device and driver.
#pragma once

#include <cstddef>
#include <filesystem>
#include <span>
#include <vector>

#include "gpu/vulkan.h"

namespace dermis::gpu {

/// Returns the driver's bytes; empty if the file is missing, damaged (with a note) or from another device or
/// driver. Never throws.
std::vector<std::byte> load_pipeline_cache(const std::filesystem::path& file,
                                           const VkPhysicalDeviceProperties& properties);

/// Writes the file completely or not at all; creates missing folders of the path. Returns whether it was
/// written, and warns if it cannot be.
bool save_pipeline_cache(const std::filesystem::path& file, const VkPhysicalDeviceProperties& properties,
                         std::span<const std::byte> bytes);

}  // namespace dermis::gpu
