// SPDX-License-Identifier: MIT
#include <algorithm>
#include <cstring>
#include <limits>

#include "base/core/assert.h"
#include "gpu/device.h"
#include "gpu/formats.h"
#include "gpu/raw.h"
#include "gpu/resources.h"
#include "gpu/texture_upload.h"
#include "gpu/transfer.h"

namespace dermis::gpu {
namespace {

/// Host memory for one transfer, which is waited for.
class Staging {
 public:
  Staging(Device& device, const std::string& name, std::uint64_t bytes, BufferPlace place)
      : device_(&device),
        raw_(create_raw_buffer(device, "staging of " + name, {.bytes = bytes, .place = place})) {}
  Staging(const Staging&) = delete;
  Staging& operator=(const Staging&) = delete;
  ~Staging() { destroy_raw_buffer(*device_, raw_); }
  VkBuffer handle() const { return raw_.handle; }
  std::byte* mapped() const { return raw_.allocation->mapped; }

 private:
  Device* device_;
  RawBuffer raw_;
};

/// Makes all writes so far visible to all that follows; changes the layout of `texture`, unless it is null.
/// Transfers run once, outside of frames, so the barrier may be coarse.
void barrier(const Device& device, VkCommandBuffer commands, const Texture* texture, VkImageLayout from,
             VkImageLayout to) {
  VkMemoryBarrier2 all{};
  all.sType = VK_STRUCTURE_TYPE_MEMORY_BARRIER_2;
  all.srcStageMask = all.dstStageMask = VK_PIPELINE_STAGE_2_ALL_COMMANDS_BIT | VK_PIPELINE_STAGE_2_HOST_BIT;
  all.srcAccessMask = VK_ACCESS_2_MEMORY_WRITE_BIT | VK_ACCESS_2_HOST_WRITE_BIT;
  all.dstAccessMask = VK_ACCESS_2_MEMORY_READ_BIT | VK_ACCESS_2_MEMORY_WRITE_BIT | VK_ACCESS_2_HOST_READ_BIT;

  VkImageMemoryBarrier2 image{};
  image.sType = VK_STRUCTURE_TYPE_IMAGE_MEMORY_BARRIER_2;
  image.srcStageMask = image.dstStageMask = VK_PIPELINE_STAGE_2_ALL_COMMANDS_BIT;
  image.srcAccessMask = VK_ACCESS_2_MEMORY_WRITE_BIT;
  image.dstAccessMask = VK_ACCESS_2_MEMORY_READ_BIT | VK_ACCESS_2_MEMORY_WRITE_BIT;
  image.oldLayout = from;
  image.newLayout = to;
  image.srcQueueFamilyIndex = image.dstQueueFamilyIndex = VK_QUEUE_FAMILY_IGNORED;

  VkDependencyInfo info{};
  info.sType = VK_STRUCTURE_TYPE_DEPENDENCY_INFO;
  info.memoryBarrierCount = 1;
  info.pMemoryBarriers = &all;
  if (texture) {
    image.image = texture->handle();
    image.subresourceRange = {aspect_of(texture->desc().format), 0, VK_REMAINING_MIP_LEVELS, 0,
                              VK_REMAINING_ARRAY_LAYERS};
    info.imageMemoryBarrierCount = 1;
    info.pImageMemoryBarriers = &image;
  }

  device.vk().vkCmdPipelineBarrier2(commands, &info);
}

/// Returns one copy per mip, from data that is tightly packed, mip after mip.
std::vector<VkBufferImageCopy> copies_of(const TextureDesc& desc) {
  std::vector<VkBufferImageCopy> copies;
  std::uint64_t offset = 0;
  for (std::uint32_t mip = 0; mip < desc.mips; ++mip) {
    VkBufferImageCopy copy{};
    copy.bufferOffset = offset;
    copy.imageSubresource = {aspect_of(desc.format), mip, 0, desc.layers};
    copy.imageExtent = {std::max(1u, desc.width >> mip), std::max(1u, desc.height >> mip), 1};
    offset += std::uint64_t{copy.imageExtent.width} * copy.imageExtent.height * desc.layers *
              texel_bytes(desc.format);
    copies.push_back(copy);
  }
  return copies;
}

}  // namespace

void upload(Device& device, const Buffer& to, std::span<const std::byte> bytes) {
  DERMIS_ASSERT_LE(bytes.size(), to.desc().bytes);
  if (bytes.empty()) return;

  const Staging staging(device, to.name(), bytes.size(), BufferPlace::upload);
  std::memcpy(staging.mapped(), bytes.data(), bytes.size());

  device.run([&](VkCommandBuffer commands) {
    const VkBufferCopy copy{0, 0, bytes.size()};
    barrier(device, commands, nullptr, {}, {});
    device.vk().vkCmdCopyBuffer(commands, staging.handle(), to.handle(), 1, &copy);
    barrier(device, commands, nullptr, {}, {});
  });
}

void upload(Device& device, const Texture& to, std::span<const std::byte> bytes) {
  const TextureDesc& desc = to.desc();
  DERMIS_ASSERT_EQ(bytes.size(), bytes_of(desc));
  DERMIS_ASSERT_EQ(desc.samples, 1u);
  DERMIS_ASSERT((desc.usage & VK_IMAGE_USAGE_SAMPLED_BIT) != 0);

  const Staging staging(device, to.name(), bytes.size(), BufferPlace::upload);
  std::memcpy(staging.mapped(), bytes.data(), bytes.size());

  device.run([&](VkCommandBuffer commands) {
    const std::vector<VkBufferImageCopy> copies = copies_of(desc);
    barrier(device, commands, &to, VK_IMAGE_LAYOUT_UNDEFINED, VK_IMAGE_LAYOUT_TRANSFER_DST_OPTIMAL);
    device.vk().vkCmdCopyBufferToImage(commands, staging.handle(), to.handle(),
                                       VK_IMAGE_LAYOUT_TRANSFER_DST_OPTIMAL,
                                       static_cast<std::uint32_t>(copies.size()), copies.data());
    barrier(device, commands, &to, VK_IMAGE_LAYOUT_TRANSFER_DST_OPTIMAL,
            VK_IMAGE_LAYOUT_SHADER_READ_ONLY_OPTIMAL);
  });
}

namespace {

constexpr std::uint64_t piece_bytes = std::uint64_t{16} << 20;

std::uint64_t row_bytes(const TextureDesc& desc, std::uint32_t mip) {
  return std::uint64_t{std::max(1u, desc.width >> mip)} * texel_bytes(desc.format);
}

}  // namespace

TextureUpload::TextureUpload(Device& device, const Texture& to)
    : device_(&device),
      to_(&to),
      staging_(device, "staging of " + to.name(),
               {.bytes = std::min(bytes_of(to.desc()), std::max(piece_bytes, row_bytes(to.desc(), 0))),
                .place = BufferPlace::upload}) {
  DERMIS_ASSERT_EQ(to.desc().layers, 1u);
  DERMIS_ASSERT_EQ(to.desc().samples, 1u);
  device_->run([&](VkCommandBuffer commands) {
    barrier(*device_, commands, to_, VK_IMAGE_LAYOUT_UNDEFINED, VK_IMAGE_LAYOUT_TRANSFER_DST_OPTIMAL);
  });
}

TextureUpload::~TextureUpload() = default;

std::uint32_t TextureUpload::rows_at_a_time(std::uint32_t mip) const {
  return static_cast<std::uint32_t>(staging_.desc().bytes / row_bytes(to_->desc(), mip));
}

void TextureUpload::rows(std::uint32_t mip, std::uint32_t first_row, std::span<const std::byte> bytes) {
  const TextureDesc& desc = to_->desc();
  const auto count = static_cast<std::uint32_t>(bytes.size() / row_bytes(desc, mip));

  DERMIS_ASSERT_LT(mip, desc.mips);
  DERMIS_ASSERT_LE(1u, count);
  DERMIS_ASSERT_LE(count, rows_at_a_time(mip));
  const std::uint32_t rows_in_all = std::max(1u, desc.height >> mip);
  DERMIS_ASSERT_LE(first_row + count, rows_in_all);

  std::memcpy(staging_.mapped().data(), bytes.data(), bytes.size());
  device_->run([&](VkCommandBuffer commands) {
    VkBufferImageCopy copy{};
    copy.imageSubresource = {aspect_of(desc.format), mip, 0, 1};
    copy.imageOffset = {0, static_cast<std::int32_t>(first_row), 0};
    copy.imageExtent = {std::max(1u, desc.width >> mip), count, 1};

    barrier(*device_, commands, nullptr, {}, {});
    device_->vk().vkCmdCopyBufferToImage(commands, staging_.handle(), to_->handle(),
                                         VK_IMAGE_LAYOUT_TRANSFER_DST_OPTIMAL, 1, &copy);
    barrier(*device_, commands, nullptr, {}, {});
  });
}

void TextureUpload::finish() {
  device_->run([&](VkCommandBuffer commands) {
    barrier(*device_, commands, to_, VK_IMAGE_LAYOUT_TRANSFER_DST_OPTIMAL,
            VK_IMAGE_LAYOUT_SHADER_READ_ONLY_OPTIMAL);
  });
}

void poison(Device& device, const Texture& texture) {
  DERMIS_ASSERT_EQ(texture.desc().samples, 1u);
  constexpr float nan = std::numeric_limits<float>::quiet_NaN();
  constexpr VkImageLayout layout = VK_IMAGE_LAYOUT_TRANSFER_DST_OPTIMAL;
  const VkImageAspectFlags aspect = aspect_of(texture.desc().format);
  const VkImageSubresourceRange all{aspect, 0, VK_REMAINING_MIP_LEVELS, 0, VK_REMAINING_ARRAY_LAYERS};

  device.run([&](VkCommandBuffer commands) {
    barrier(device, commands, &texture, VK_IMAGE_LAYOUT_UNDEFINED, layout);
    if (aspect == VK_IMAGE_ASPECT_DEPTH_BIT) {
      const VkClearDepthStencilValue half{0.5f, 0};
      device.vk().vkCmdClearDepthStencilImage(commands, texture.handle(), layout, &half, 1, &all);
    } else {
      const VkClearColorValue none{.float32 = {nan, nan, nan, nan}};
      device.vk().vkCmdClearColorImage(commands, texture.handle(), layout, &none, 1, &all);
    }
    barrier(device, commands, nullptr, {}, {});
  });
}

namespace {

void record_copy(Device& device, VkCommandBuffer commands, const Texture& from, VkImageLayout layout,
                 std::uint32_t layer, VkBuffer to) {
  const TextureDesc& desc = from.desc();
  VkBufferImageCopy copy{};
  copy.imageSubresource = {aspect_of(desc.format), 0, layer, 1};
  copy.imageExtent = {desc.width, desc.height, 1};

  barrier(device, commands, &from, layout, VK_IMAGE_LAYOUT_TRANSFER_SRC_OPTIMAL);
  device.vk().vkCmdCopyImageToBuffer(commands, from.handle(), VK_IMAGE_LAYOUT_TRANSFER_SRC_OPTIMAL, to, 1,
                                     &copy);
  barrier(device, commands, &from, VK_IMAGE_LAYOUT_TRANSFER_SRC_OPTIMAL, layout);
}

void record_copy(Device& device, VkCommandBuffer commands, const Buffer& from, VkBuffer to) {
  const VkBufferCopy copy{0, 0, from.desc().bytes};
  barrier(device, commands, nullptr, {}, {});
  device.vk().vkCmdCopyBuffer(commands, from.handle(), to, 1, &copy);
  barrier(device, commands, nullptr, {}, {});
}

}  // namespace

void record_read_back(Device& device, VkCommandBuffer commands, const Texture& from, VkImageLayout layout,
                      const Buffer& to) {
  const TextureDesc& desc = from.desc();
  DERMIS_ASSERT_EQ(desc.samples, 1u);
  DERMIS_ASSERT_EQ(std::uint64_t{desc.width} * desc.height * texel_bytes(desc.format), to.desc().bytes);
  record_copy(device, commands, from, layout, 0, to.handle());
}

void record_read_back(Device& device, VkCommandBuffer commands, const Buffer& from, const Buffer& to) {
  DERMIS_ASSERT_EQ(from.desc().bytes, to.desc().bytes);
  record_copy(device, commands, from, to.handle());
}

std::vector<std::byte> read_back(Device& device, const Texture& from, VkImageLayout layout,
                                 std::uint32_t layer) {
  const TextureDesc& desc = from.desc();
  DERMIS_ASSERT_EQ(desc.samples, 1u);
  DERMIS_ASSERT_LT(layer, desc.layers);
  DERMIS_ASSERT(layout != VK_IMAGE_LAYOUT_UNDEFINED);

  const std::uint64_t bytes = std::uint64_t{desc.width} * desc.height * texel_bytes(desc.format);
  const Staging staging(device, from.name(), bytes, BufferPlace::readback);

  device.run([&](VkCommandBuffer commands) {
    record_copy(device, commands, from, layout, layer, staging.handle());
  });
  return {staging.mapped(), staging.mapped() + bytes};
}

std::vector<std::byte> read_back(Device& device, const Buffer& from) {
  const std::uint64_t bytes = from.desc().bytes;
  const Staging staging(device, from.name(), bytes, BufferPlace::readback);
  device.run([&](VkCommandBuffer commands) { record_copy(device, commands, from, staging.handle()); });
  return {staging.mapped(), staging.mapped() + bytes};
}

}  // namespace dermis::gpu
