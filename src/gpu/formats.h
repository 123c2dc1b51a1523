// SPDX-License-Identifier: MIT
// The formats that textures of this library may have.
#pragma once

#include <cstdint>

#include "gpu/vulkan.h"

namespace dermis::gpu {

/// Returns the bytes per texel (of one sample). Asserts that the format is known.
std::uint32_t texel_bytes(VkFormat format);
const char* format_name(VkFormat format);  ///< "R8G8B8A8_SRGB"; "unknown format"

}  // namespace dermis::gpu
