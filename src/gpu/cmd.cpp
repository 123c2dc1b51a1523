// SPDX-License-Identifier: MIT
#include "gpu/cmd.h"

#include <algorithm>
#include <array>

#include "base/core/assert.h"
#include "gpu/device.h"

namespace dermis::gpu {
namespace {

/// The descriptor writes, and the arrays that they point into.
struct Writes {
  std::vector<VkDescriptorImageInfo> images;
  std::vector<VkDescriptorBufferInfo> buffers;
  std::vector<VkBufferView> views;
  std::vector<VkWriteDescriptorSet> writes;
};

bool fits(const Binding& binding, BindingKind kind) {
  switch (kind) {
    case BindingKind::sampled_image: return std::holds_alternative<SampledBinding>(binding);
    case BindingKind::storage_image: return std::holds_alternative<StorageImageBinding>(binding);
    case BindingKind::storage_buffer:
    case BindingKind::uniform_buffer:
    case BindingKind::texel_buffer: return std::holds_alternative<BufferBinding>(binding);
  }
  return false;
}

[[noreturn]] void wrong_kind(const Pipeline& pipeline, const BindingSlot& slot) {
  assertion_failed("binding is of the kind that the shader declares",
                   fmt::format("{}: binding {} '{}'", pipeline.name, slot.binding, slot.name), __FILE__,
                   __LINE__);
}

void add(Writes& out, const Pipeline& pipeline, const BindingSlot& slot, std::uint32_t element,
         const Binding& binding) {
  if (!fits(binding, slot.kind)) wrong_kind(pipeline, slot);

  VkWriteDescriptorSet write{};
  write.sType = VK_STRUCTURE_TYPE_WRITE_DESCRIPTOR_SET;
  write.dstBinding = slot.binding;
  write.dstArrayElement = element;
  write.descriptorCount = 1;
  write.descriptorType = descriptor_type(slot.kind);

  if (const auto* sampled = std::get_if<SampledBinding>(&binding)) {
    DERMIS_ASSERT(sampled->texture && sampled->texture->view() && sampled->sampler);
    write.pImageInfo = &out.images.emplace_back(
        VkDescriptorImageInfo{sampled->sampler, sampled->texture->view(), sampled->layout});
  } else if (const auto* image = std::get_if<StorageImageBinding>(&binding)) {
    DERMIS_ASSERT(image->texture && image->texture->view());
    write.pImageInfo = &out.images.emplace_back(
        VkDescriptorImageInfo{VK_NULL_HANDLE, image->texture->view(), VK_IMAGE_LAYOUT_GENERAL});
  } else {
    const auto& buffer = std::get<BufferBinding>(binding);
    DERMIS_ASSERT(buffer.buffer && *buffer.buffer);
    if (slot.kind == BindingKind::texel_buffer) {
      DERMIS_ASSERT(buffer.buffer->texel_view() && buffer.offset == 0 && buffer.bytes == VK_WHOLE_SIZE);
      write.pTexelBufferView = &out.views.emplace_back(buffer.buffer->texel_view());
    } else {
      write.pBufferInfo = &out.buffers.emplace_back(
          VkDescriptorBufferInfo{buffer.buffer->handle(), buffer.offset, buffer.bytes});
    }
  }

  out.writes.push_back(write);
}

VkRenderingAttachmentInfo attachment(VkImageView view, VkImageLayout layout) {
  VkRenderingAttachmentInfo info{};
  info.sType = VK_STRUCTURE_TYPE_RENDERING_ATTACHMENT_INFO;
  info.imageView = view;
  info.imageLayout = layout;
  info.loadOp = VK_ATTACHMENT_LOAD_OP_LOAD;
  info.storeOp = VK_ATTACHMENT_STORE_OP_STORE;
  return info;
}

VkRenderingAttachmentInfo colour_attachment(const ColourTarget& target) {
  VkRenderingAttachmentInfo info = attachment(target.texture->layer_view(target.layer), colour_target_layout);
  if (target.clear) {
    info.loadOp = VK_ATTACHMENT_LOAD_OP_CLEAR;
    const auto& c = *target.clear;
    info.clearValue.color = {{c[0], c[1], c[2], c[3]}};
  }
  if (target.resolve) {
    info.resolveMode = VK_RESOLVE_MODE_AVERAGE_BIT;
    info.resolveImageView = target.resolve->layer_view(0);
    info.resolveImageLayout = colour_target_layout;
  }
  return info;
}

VkRenderingAttachmentInfo depth_attachment(const DepthTarget& target) {
  VkRenderingAttachmentInfo info = attachment(target.texture->layer_view(target.layer), depth_target_layout);
  if (target.clear) {
    info.loadOp = VK_ATTACHMENT_LOAD_OP_CLEAR;
    info.clearValue.depthStencil = {*target.clear, 0};
  }
  if (!target.store) info.storeOp = VK_ATTACHMENT_STORE_OP_DONT_CARE;
  return info;
}

}  // namespace

Cmd::Cmd(Device& device, VkCommandBuffer handle, Work before)
    : device_(&device), handle_(handle), last_(before) {}

void Cmd::goes_on_with(Work work) {
  if (last_ != Work::none && last_ != work) ++recorded_.switches;
  last_ = work;
}

void Cmd::bind(const Pipeline& pipeline, std::span<const Binding> bindings) {
  const auto& vk = device_->vk();
  vk.vkCmdBindPipeline(handle_, pipeline.bind_point, pipeline.handle);
  if (pipeline.bind_point == VK_PIPELINE_BIND_POINT_GRAPHICS)
    vk.vkCmdSetCullMode(handle_, pipeline.cull_mode);
  Writes out;
  out.images.reserve(bindings.size());  // never reallocated: the writes point into these
  out.buffers.reserve(bindings.size());
  out.views.reserve(bindings.size());
  std::size_t next = 0;
  for (const BindingSlot& slot : pipeline.interface.bindings)
    for (std::uint32_t element = 0; element < slot.count; ++element, ++next)
      if (next < bindings.size()) add(out, pipeline, slot, element, bindings[next]);
  if (next != bindings.size())
    assertion_failed("as many bindings as the shader declares",
                     fmt::format("{}: {} given, {} declared", pipeline.name, bindings.size(), next), __FILE__,
                     __LINE__);
  if (out.writes.empty()) return;
  vk.vkCmdPushDescriptorSetKHR(handle_, pipeline.bind_point, pipeline.layout, 0,
                               static_cast<std::uint32_t>(out.writes.size()), out.writes.data());
}

void Cmd::push_bytes(const Pipeline& pipeline, std::span<const std::byte> values) {
  if (values.size() != pipeline.interface.push_bytes)
    assertion_failed(
        "push constants have the size that the shader declares",
        fmt::format("{}: {} given, {} declared", pipeline.name, values.size(), pipeline.interface.push_bytes),
        __FILE__, __LINE__);
  device_->vk().vkCmdPushConstants(handle_, pipeline.layout, pipeline.push_stages, 0,
                                   static_cast<std::uint32_t>(values.size()), values.data());
}

void Cmd::dispatch(std::uint32_t groups_x, std::uint32_t groups_y, std::uint32_t groups_z) {
  const auto& most = device_->limits().max_workgroups;
  DERMIS_ASSERT_LE(groups_x, most[0]);
  DERMIS_ASSERT_LE(groups_y, most[1]);
  DERMIS_ASSERT_LE(groups_z, most[2]);
  device_->vk().vkCmdDispatch(handle_, groups_x, groups_y, groups_z);
  ++recorded_.dispatches;
  goes_on_with(Work::compute);
}

void Cmd::dispatch_over(const Pipeline& pipeline, std::uint32_t threads_x, std::uint32_t threads_y,
                        std::uint32_t threads_z) {
  const auto groups = [&](std::uint32_t threads, int axis) {
    const std::uint32_t size = pipeline.interface.workgroup[static_cast<std::size_t>(axis)];
    return threads / size + (threads % size != 0);
  };
  dispatch(groups(threads_x, 0), groups(threads_y, 1), groups(threads_z, 2));
}

void Cmd::dispatch_indirect(const Buffer& arguments, std::uint64_t offset) {
  DERMIS_ASSERT_LE(offset + sizeof(VkDispatchIndirectCommand), arguments.desc().bytes);
  device_->vk().vkCmdDispatchIndirect(handle_, arguments.handle(), offset);
  ++recorded_.dispatches;
  goes_on_with(Work::compute);
}

void Cmd::begin_rendering_area(std::span<const ColourTarget> colour, const std::optional<DepthTarget>& depth,
                               VkRect2D area, bool y_down) {
  std::vector<VkRenderingAttachmentInfo> attachments;
  std::uint64_t cleared = depth && depth->clear ? 1 : 0;
  for (const ColourTarget& target : colour) {
    attachments.push_back(colour_attachment(target));
    cleared += target.clear ? 1 : 0;
  }
  recorded_.cleared_pixels += cleared * area.extent.width * area.extent.height;
  ++recorded_.renderings;
  goes_on_with(Work::rendering);
  VkRenderingInfo info{};
  info.sType = VK_STRUCTURE_TYPE_RENDERING_INFO;
  info.renderArea = area;
  info.layerCount = 1;
  info.colorAttachmentCount = static_cast<std::uint32_t>(attachments.size());
  info.pColorAttachments = attachments.data();
  VkRenderingAttachmentInfo depth_info{};
  if (depth) {
    depth_info = depth_attachment(*depth);
    info.pDepthAttachment = &depth_info;
  }
  device_->vk().vkCmdBeginRendering(handle_, &info);
  set_viewport(area, y_down);
}

void Cmd::set_viewport(VkRect2D area, bool y_down) {
  VkViewport viewport{};
  viewport.x = static_cast<float>(area.offset.x);
  viewport.y = static_cast<float>(area.offset.y);
  viewport.width = static_cast<float>(area.extent.width);
  viewport.height = static_cast<float>(area.extent.height);
  viewport.maxDepth = 1;
  if (!y_down) {
    viewport.y += viewport.height;
    viewport.height = -viewport.height;
  }
  device_->vk().vkCmdSetViewport(handle_, 0, 1, &viewport);
  set_scissor(area);
}

void Cmd::set_scissor(VkRect2D area) { device_->vk().vkCmdSetScissor(handle_, 0, 1, &area); }

void Cmd::end_rendering() { device_->vk().vkCmdEndRendering(handle_); }

void Cmd::draw(std::uint32_t vertices, std::uint32_t instances, std::uint32_t first_vertex,
               std::uint32_t first_instance) {
  device_->vk().vkCmdDraw(handle_, vertices, instances, first_vertex, first_instance);
  ++recorded_.draws;
}

void Cmd::draw_indexed(const BufferBinding& indices, std::uint32_t count, std::uint32_t first,
                       std::uint32_t instances, std::uint32_t first_instance) {
  DERMIS_ASSERT(indices.buffer && *indices.buffer);
  DERMIS_ASSERT_LE(indices.offset + (std::uint64_t{first} + count) * sizeof(std::uint32_t),
                   indices.buffer->desc().bytes);
  device_->vk().vkCmdBindIndexBuffer(handle_, indices.buffer->handle(), indices.offset, VK_INDEX_TYPE_UINT32);
  device_->vk().vkCmdDrawIndexed(handle_, count, instances, first, 0, first_instance);
  ++recorded_.draws;
}

void Cmd::copy(const Buffer& from, const Buffer& to, std::uint64_t bytes) {
  DERMIS_ASSERT_LE(bytes, from.desc().bytes);
  DERMIS_ASSERT_LE(bytes, to.desc().bytes);
  const VkBufferCopy region{0, 0, bytes};
  device_->vk().vkCmdCopyBuffer(handle_, from.handle(), to.handle(), 1, &region);
}

void Cmd::copy(const Texture& from, const Buffer& to, std::uint32_t layer) {
  const TextureDesc& desc = from.desc();
  const TextureDesc one{.width = desc.width, .height = desc.height, .format = desc.format};
  DERMIS_ASSERT_LT(layer, desc.layers);
  DERMIS_ASSERT_LE(bytes_of(one), to.desc().bytes);
  VkBufferImageCopy region{};
  region.imageSubresource = {aspect_of(desc.format), 0, layer, 1};
  region.imageExtent = {desc.width, desc.height, 1};
  device_->vk().vkCmdCopyImageToBuffer(handle_, from.handle(), VK_IMAGE_LAYOUT_TRANSFER_SRC_OPTIMAL,
                                       to.handle(), 1, &region);
}

void Cmd::fill(const Buffer& to, std::uint32_t value) {
  device_->vk().vkCmdFillBuffer(handle_, to.handle(), 0, VK_WHOLE_SIZE, value);
}

void Cmd::update(const Buffer& to, std::span<const std::byte> bytes) {
  constexpr std::size_t most = 65536;  // of one command
  DERMIS_ASSERT_LE(bytes.size(), to.desc().bytes);
  for (std::size_t at = 0; at < bytes.size(); at += most)
    device_->vk().vkCmdUpdateBuffer(handle_, to.handle(), at, std::min(bytes.size() - at, most), &bytes[at]);
}

void Cmd::barrier(const VkDependencyInfo& dependencies) {
  device_->vk().vkCmdPipelineBarrier2(handle_, &dependencies);
  ++recorded_.barriers;
}

void Cmd::barrier_all() {
  VkMemoryBarrier2 all{};
  all.sType = VK_STRUCTURE_TYPE_MEMORY_BARRIER_2;
  all.srcStageMask = all.dstStageMask = VK_PIPELINE_STAGE_2_ALL_COMMANDS_BIT;
  all.srcAccessMask = VK_ACCESS_2_MEMORY_WRITE_BIT;
  all.dstAccessMask = VK_ACCESS_2_MEMORY_READ_BIT | VK_ACCESS_2_MEMORY_WRITE_BIT;
  barrier({.sType = VK_STRUCTURE_TYPE_DEPENDENCY_INFO, .memoryBarrierCount = 1, .pMemoryBarriers = &all});
}

}  // namespace dermis::gpu
