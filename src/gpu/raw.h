// SPDX-License-Identifier: MIT
// A buffer without a lifetime of its own, for staging: it is destroyed by hand as soon as its one submission
// has completed, which an engine's device would otherwise put off until collect().
#pragma once

#include <string>

#include "gpu/device.h"
#include "gpu/memory.h"
#include "gpu/resources.h"

namespace dermis::gpu {

struct RawBuffer {
  VkBuffer handle = VK_NULL_HANDLE;
  MemoryPool::Allocation* allocation = nullptr;
};
RawBuffer create_raw_buffer(Device& device, const std::string& name, const BufferDesc& desc);
void destroy_raw_buffer(Device& device, const RawBuffer& buffer);

}  // namespace dermis::gpu
