// SPDX-License-Identifier: MIT
// Copies to the host that a frame records along with its passes. Whole transfers that wait are those of
// gpu/resources.h.
#pragma once

#include "gpu/resources.h"
#include "gpu/vulkan.h"

namespace dermis::gpu {

/// Record the copy of mip 0 of a texture's first layer, tightly packed, or of a buffer, into a buffer of the
/// place `readback` that is as large, with the barriers around it. The texture must be in `layout` and
/// returns to it. The host may read once the commands have completed.
void record_read_back(Device& device, VkCommandBuffer commands, const Texture& from, VkImageLayout layout,
                      const Buffer& to);
void record_read_back(Device& device, VkCommandBuffer commands, const Buffer& from, const Buffer& to);

}  // namespace dermis::gpu
