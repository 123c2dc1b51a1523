// SPDX-License-Identifier: MIT
#include "gpu/frame_memory.h"

#include <algorithm>
#include <cstring>

#include "base/core/assert.h"
#include "gpu/device.h"

namespace dermis::gpu {
namespace {

// The most that Vulkan lets a device ask for, of uniform and of storage buffers.
constexpr std::size_t alignment = 256;
constexpr std::uint64_t least_bytes = std::uint64_t{64} << 10;

std::size_t aligned(std::size_t bytes) { return (bytes + alignment - 1) / alignment * alignment; }

}  // namespace

BufferBinding FrameMemory::add_bytes(std::span<const std::byte> bytes, std::size_t element_bytes) {
  const std::size_t offset = bytes_.size(), used = std::max(bytes.size(), element_bytes);
  bytes_.resize(aligned(offset + used));
  if (!bytes.empty()) std::memcpy(bytes_.data() + offset, bytes.data(), bytes.size());
  return {&on_device_, offset, used};
}

void FrameMemory::replace_bytes(const BufferBinding& binding, std::span<const std::byte> bytes) {
  DERMIS_ASSERT_EQ(binding.buffer == &on_device_, true);
  DERMIS_ASSERT_EQ(binding.bytes, std::uint64_t{bytes.size()});
  DERMIS_ASSERT_LE(binding.offset + binding.bytes, std::uint64_t{bytes_.size()});
  std::memcpy(bytes_.data() + binding.offset, bytes.data(), bytes.size());
}

void FrameMemory::reserve(std::uint64_t bytes) {
  if (staging_ && staging_.desc().bytes >= bytes) return;
  const std::uint64_t room = std::max<std::uint64_t>(least_bytes, aligned(2 * bytes));
  staging_ = Buffer(*device_, name_ + " staging", {.bytes = room, .place = BufferPlace::upload});
  on_device_ = Buffer(*device_, name_,
                      {.bytes = room, .usage = texels_of_shaders | VK_BUFFER_USAGE_UNIFORM_BUFFER_BIT});
}

void FrameMemory::record(VkCommandBuffer commands) {
  if (bytes_.empty()) return;
  reserve(bytes_.size());
  std::memcpy(staging_.mapped().data(), bytes_.data(), bytes_.size());

  const VkBufferCopy copy{0, 0, bytes_.size()};
  device_->vk().vkCmdCopyBuffer(commands, staging_.handle(), on_device_.handle(), 1, &copy);

  VkMemoryBarrier2 barrier{};
  barrier.sType = VK_STRUCTURE_TYPE_MEMORY_BARRIER_2;
  barrier.srcStageMask = VK_PIPELINE_STAGE_2_COPY_BIT;
  barrier.srcAccessMask = VK_ACCESS_2_TRANSFER_WRITE_BIT;
  barrier.dstStageMask = VK_PIPELINE_STAGE_2_ALL_COMMANDS_BIT;
  barrier.dstAccessMask = VK_ACCESS_2_UNIFORM_READ_BIT | VK_ACCESS_2_SHADER_STORAGE_READ_BIT |
                          VK_ACCESS_2_SHADER_SAMPLED_READ_BIT;
  Cmd(*device_, commands)
      .barrier(
          {.sType = VK_STRUCTURE_TYPE_DEPENDENCY_INFO, .memoryBarrierCount = 1, .pMemoryBarriers = &barrier});
}

void FrameMemory::upload() {
  device_->run([&](VkCommandBuffer commands) { record(commands); });
}

}  // namespace dermis::gpu
