// SPDX-License-Identifier: MIT
#include "viewer/window/ui_renderer.h"

#include <imgui.h>

#include <algorithm>
#include <cstring>

#include "viewer/window/ui_pipeline.h"

namespace dermis::viewer {
namespace {

void record_layout(VkCommandBuffer commands, VkImage image, VkImageLayout from, VkImageLayout to) {
  VkImageMemoryBarrier2 barrier{VK_STRUCTURE_TYPE_IMAGE_MEMORY_BARRIER_2};
  barrier.srcStageMask = barrier.dstStageMask = VK_PIPELINE_STAGE_2_ALL_COMMANDS_BIT;
  barrier.srcAccessMask = VK_ACCESS_2_MEMORY_WRITE_BIT;
  barrier.dstAccessMask = VK_ACCESS_2_MEMORY_READ_BIT | VK_ACCESS_2_MEMORY_WRITE_BIT;
  barrier.oldLayout = from;
  barrier.newLayout = to;
  barrier.srcQueueFamilyIndex = barrier.dstQueueFamilyIndex = VK_QUEUE_FAMILY_IGNORED;
  barrier.image = image;
  barrier.subresourceRange = {VK_IMAGE_ASPECT_COLOR_BIT, 0, 1, 0, 1};
  VkDependencyInfo info{VK_STRUCTURE_TYPE_DEPENDENCY_INFO};
  info.imageMemoryBarrierCount = 1;
  info.pImageMemoryBarriers = &barrier;
  vkCmdPipelineBarrier2(commands, &info);
}

// A buffer of at least so many bytes; one that grows does so by half.
void make_room(const PresentDevice& device, HostBuffer& buffer, VkDeviceSize bytes, VkBufferUsageFlags use) {
  if (buffer.bytes >= bytes && buffer.bytes > 0) return;
  buffer = {};
  buffer = device.make_buffer(std::max<VkDeviceSize>(bytes + bytes / 2, 65536), use);
}

}  // namespace

UiRenderer::UiRenderer(const PresentDevice& device, VkFormat target) : device_(device) {
  make_layouts();
  pipeline_ = make_ui_pipeline(device.handle(), layout_.get(), target);

  unsigned char* pixels = nullptr;
  int width = 0, height = 0;
  ImGui::GetIO().Fonts->GetTexDataAsRGBA32(&pixels, &width, &height);
  set_picture(PictureSlot::font, width, height,
              {pixels, static_cast<std::size_t>(width) * static_cast<std::size_t>(height) * 4});
  ImGui::GetIO().Fonts->SetTexID(texture_id(PictureSlot::font));
}

void UiRenderer::make_layouts() {
  const VkDevice device = device_.handle();
  VkSamplerCreateInfo sampler_info{VK_STRUCTURE_TYPE_SAMPLER_CREATE_INFO};
  sampler_info.magFilter = sampler_info.minFilter = VK_FILTER_LINEAR;
  sampler_info.addressModeU = sampler_info.addressModeV = VK_SAMPLER_ADDRESS_MODE_CLAMP_TO_EDGE;
  VkSampler sampler = VK_NULL_HANDLE;
  check(vkCreateSampler(device, &sampler_info, nullptr, &sampler), "vkCreateSampler");
  sampler_ = {device, sampler, vkDestroySampler};

  VkDescriptorSetLayoutBinding binding{};
  binding.descriptorType = VK_DESCRIPTOR_TYPE_COMBINED_IMAGE_SAMPLER;
  binding.descriptorCount = 1;
  binding.stageFlags = VK_SHADER_STAGE_FRAGMENT_BIT;
  binding.pImmutableSamplers = &sampler;
  VkDescriptorSetLayoutCreateInfo set_info{VK_STRUCTURE_TYPE_DESCRIPTOR_SET_LAYOUT_CREATE_INFO};
  set_info.bindingCount = 1;
  set_info.pBindings = &binding;
  VkDescriptorSetLayout set_layout = VK_NULL_HANDLE;
  check(vkCreateDescriptorSetLayout(device, &set_info, nullptr, &set_layout), "vkCreateDescriptorSetLayout");
  set_layout_ = {device, set_layout, vkDestroyDescriptorSetLayout};

  const VkPushConstantRange push{VK_SHADER_STAGE_VERTEX_BIT, 0, 4 * sizeof(float)};
  VkPipelineLayoutCreateInfo info{VK_STRUCTURE_TYPE_PIPELINE_LAYOUT_CREATE_INFO};
  info.setLayoutCount = 1;
  info.pSetLayouts = &set_layout;
  info.pushConstantRangeCount = 1;
  info.pPushConstantRanges = &push;
  VkPipelineLayout layout = VK_NULL_HANDLE;
  check(vkCreatePipelineLayout(device, &info, nullptr, &layout), "vkCreatePipelineLayout");
  layout_ = {device, layout, vkDestroyPipelineLayout};

  const VkDescriptorPoolSize size{VK_DESCRIPTOR_TYPE_COMBINED_IMAGE_SAMPLER, picture_slots};
  VkDescriptorPoolCreateInfo pool_info{VK_STRUCTURE_TYPE_DESCRIPTOR_POOL_CREATE_INFO};
  pool_info.maxSets = picture_slots;
  pool_info.poolSizeCount = 1;
  pool_info.pPoolSizes = &size;
  VkDescriptorPool pool = VK_NULL_HANDLE;
  check(vkCreateDescriptorPool(device, &pool_info, nullptr, &pool), "vkCreateDescriptorPool");
  pool_ = {device, pool, vkDestroyDescriptorPool};

  for (Slot& slot : slots_) {
    VkDescriptorSetAllocateInfo allocate{VK_STRUCTURE_TYPE_DESCRIPTOR_SET_ALLOCATE_INFO};
    allocate.descriptorPool = pool;
    allocate.descriptorSetCount = 1;
    allocate.pSetLayouts = &set_layout;
    check(vkAllocateDescriptorSets(device, &allocate, &slot.set), "vkAllocateDescriptorSets");
  }
}

void UiRenderer::set_picture(PictureSlot slot, int width, int height, std::span<const std::uint8_t> rgba) {
  Slot& to = slots_.at(static_cast<std::size_t>(slot));
  to.waiting.assign(rgba.begin(), rgba.end());
  to.extent = {static_cast<std::uint32_t>(width), static_cast<std::uint32_t>(height)};
}

void UiRenderer::upload(VkCommandBuffer commands, Slot& slot) {
  if (slot.waiting.empty()) return;
  make_room(device_, slot.staging, slot.waiting.size(), VK_BUFFER_USAGE_TRANSFER_SRC_BIT);
  std::memcpy(slot.staging.mapped, slot.waiting.data(), slot.waiting.size());
  slot.waiting.clear();

  if (slot.image.extent.width != slot.extent.width || slot.image.extent.height != slot.extent.height) {
    slot.image = {};
    slot.image = device_.make_image(slot.extent);
    VkDescriptorImageInfo image{VK_NULL_HANDLE, slot.image.view.get(),
                                VK_IMAGE_LAYOUT_SHADER_READ_ONLY_OPTIMAL};
    VkWriteDescriptorSet write{VK_STRUCTURE_TYPE_WRITE_DESCRIPTOR_SET};
    write.dstSet = slot.set;
    write.descriptorCount = 1;
    write.descriptorType = VK_DESCRIPTOR_TYPE_COMBINED_IMAGE_SAMPLER;
    write.pImageInfo = &image;
    vkUpdateDescriptorSets(device_.handle(), 1, &write, 0, nullptr);
  }

  const VkImage image = slot.image.image.get();
  record_layout(commands, image, VK_IMAGE_LAYOUT_UNDEFINED, VK_IMAGE_LAYOUT_TRANSFER_DST_OPTIMAL);
  VkBufferImageCopy region{};
  region.imageSubresource = {VK_IMAGE_ASPECT_COLOR_BIT, 0, 0, 1};
  region.imageExtent = {slot.extent.width, slot.extent.height, 1};
  vkCmdCopyBufferToImage(commands, slot.staging.buffer.get(), image, VK_IMAGE_LAYOUT_TRANSFER_DST_OPTIMAL, 1,
                         &region);
  record_layout(commands, image, VK_IMAGE_LAYOUT_TRANSFER_DST_OPTIMAL,
                VK_IMAGE_LAYOUT_SHADER_READ_ONLY_OPTIMAL);
}

void UiRenderer::copy_vertices(const ImDrawData& lists) {
  const auto vertex_bytes = static_cast<VkDeviceSize>(lists.TotalVtxCount) * sizeof(ImDrawVert);
  const auto index_bytes = static_cast<VkDeviceSize>(lists.TotalIdxCount) * sizeof(ImDrawIdx);
  make_room(device_, vertices_, vertex_bytes, VK_BUFFER_USAGE_VERTEX_BUFFER_BIT);
  make_room(device_, indices_, index_bytes, VK_BUFFER_USAGE_INDEX_BUFFER_BIT);

  std::byte *vertex = vertices_.mapped, *index = indices_.mapped;
  for (int i = 0; i < lists.CmdListsCount; ++i) {
    const ImDrawList& list = *lists.CmdLists[i];
    const std::size_t list_vertices = static_cast<std::size_t>(list.VtxBuffer.Size) * sizeof(ImDrawVert);
    const std::size_t list_indices = static_cast<std::size_t>(list.IdxBuffer.Size) * sizeof(ImDrawIdx);
    std::memcpy(vertex, list.VtxBuffer.Data, list_vertices);
    std::memcpy(index, list.IdxBuffer.Data, list_indices);
    vertex += list_vertices;
    index += list_indices;
  }
}

void UiRenderer::record(const Swapchain::Frame& frame, const ImDrawData& lists,
                        const std::array<float, 4>& ground) {
  for (Slot& slot : slots_) upload(frame.commands, slot);
  copy_vertices(lists);

  VkRenderingAttachmentInfo target{VK_STRUCTURE_TYPE_RENDERING_ATTACHMENT_INFO};
  target.imageView = frame.view;
  target.imageLayout = VK_IMAGE_LAYOUT_COLOR_ATTACHMENT_OPTIMAL;
  target.loadOp = VK_ATTACHMENT_LOAD_OP_CLEAR;
  target.storeOp = VK_ATTACHMENT_STORE_OP_STORE;
  std::copy(ground.begin(), ground.end(), target.clearValue.color.float32);
  VkRenderingInfo info{VK_STRUCTURE_TYPE_RENDERING_INFO};
  info.renderArea.extent = frame.extent;
  info.layerCount = 1;
  info.colorAttachmentCount = 1;
  info.pColorAttachments = &target;
  vkCmdBeginRendering(frame.commands, &info);
  draw(frame.commands, frame.extent, lists);
  vkCmdEndRendering(frame.commands);
}

void UiRenderer::draw(VkCommandBuffer commands, VkExtent2D extent, const ImDrawData& lists) const {
  if (lists.TotalIdxCount == 0) return;
  vkCmdBindPipeline(commands, VK_PIPELINE_BIND_POINT_GRAPHICS, pipeline_.get());
  const VkBuffer vertices = vertices_.buffer.get();
  const VkDeviceSize start = 0;
  vkCmdBindVertexBuffers(commands, 0, 1, &vertices, &start);
  vkCmdBindIndexBuffer(commands, indices_.buffer.get(), 0,
                       sizeof(ImDrawIdx) == 2 ? VK_INDEX_TYPE_UINT16 : VK_INDEX_TYPE_UINT32);
  const VkViewport viewport{0, 0, static_cast<float>(extent.width), static_cast<float>(extent.height), 0, 1};
  vkCmdSetViewport(commands, 0, 1, &viewport);

  const ImVec2 scale(2 / lists.DisplaySize.x, 2 / lists.DisplaySize.y);
  const float push[4] = {scale.x, scale.y, -1 - lists.DisplayPos.x * scale.x,
                         -1 - lists.DisplayPos.y * scale.y};
  vkCmdPushConstants(commands, layout_.get(), VK_SHADER_STAGE_VERTEX_BIT, 0, sizeof(push), push);

  std::uint32_t first_index = 0;
  std::int32_t first_vertex = 0;
  for (int i = 0; i < lists.CmdListsCount; ++i) {
    const ImDrawList& list = *lists.CmdLists[i];
    for (const ImDrawCmd& command : list.CmdBuffer) {
      const auto slot = static_cast<std::size_t>(reinterpret_cast<std::uintptr_t>(command.GetTexID())) - 1;
      const auto cut = [](float value, float factor, std::uint32_t most) {
        return std::clamp(value * factor, 0.0f, static_cast<float>(most));
      };
      const ImVec2 pixels = lists.FramebufferScale;
      const float left = cut(command.ClipRect.x - lists.DisplayPos.x, pixels.x, extent.width);
      const float top = cut(command.ClipRect.y - lists.DisplayPos.y, pixels.y, extent.height);
      const float right = cut(command.ClipRect.z - lists.DisplayPos.x, pixels.x, extent.width);
      const float bottom = cut(command.ClipRect.w - lists.DisplayPos.y, pixels.y, extent.height);
      if (right <= left || bottom <= top || slot >= picture_slots || !slots_[slot].image.view.get()) continue;

      const VkRect2D scissor{
          {static_cast<std::int32_t>(left), static_cast<std::int32_t>(top)},
          {static_cast<std::uint32_t>(right - left), static_cast<std::uint32_t>(bottom - top)}};
      vkCmdSetScissor(commands, 0, 1, &scissor);
      vkCmdBindDescriptorSets(commands, VK_PIPELINE_BIND_POINT_GRAPHICS, layout_.get(), 0, 1,
                              &slots_[slot].set, 0, nullptr);
      vkCmdDrawIndexed(commands, command.ElemCount, 1, first_index + command.IdxOffset,
                       first_vertex + static_cast<std::int32_t>(command.VtxOffset), 0);
    }
    first_index += static_cast<std::uint32_t>(list.IdxBuffer.Size);
    first_vertex += list.VtxBuffer.Size;
  }
}

}  // namespace dermis::viewer
