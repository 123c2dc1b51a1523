// SPDX-License-Identifier: MIT
// A buffer for staging, destroyed by hand as soon as its one submission has completed. On an engine's device,
// retire() would keep it until collect().
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
