// SPDX-License-Identifier: MIT
// The file that keeps driver code between runs. Drivers check their own header only, and crash on what
// follows if it is damaged; so the file is one of core/cache.h, with a checksum, and a header of ours comes
// first, with the identity of the device and driver.
#pragma once

#include <volk.h>

#include <cstddef>
#include <filesystem>
#include <span>
#include <vector>

namespace dermis::gpu {

/// The driver's bytes; empty if the file is missing, damaged or from another device or driver. A damaged
/// file is a note. Never throws.
std::vector<std::byte> load_pipeline_cache(const std::filesystem::path& file,
                                           const VkPhysicalDeviceProperties& properties);

/// Writes it whole or not at all, making the last folder or two of the path if need be. Failing is a warning.
void save_pipeline_cache(const std::filesystem::path& file, const VkPhysicalDeviceProperties& properties,
                         std::span<const std::byte> bytes);

}  // namespace dermis::gpu
