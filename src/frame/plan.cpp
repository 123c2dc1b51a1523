// SPDX-License-Identifier: MIT
#include "frame/plan.h"

namespace dermis::frame {
namespace {

VkImageUsageFlags usage_of(Access access) {
  switch (access) {
    case Access::sampled: return VK_IMAGE_USAGE_SAMPLED_BIT;
    case Access::storage_read:
    case Access::storage_write: return VK_IMAGE_USAGE_STORAGE_BIT;
    case Access::colour_target: return VK_IMAGE_USAGE_COLOR_ATTACHMENT_BIT;
    case Access::depth_target: return VK_IMAGE_USAGE_DEPTH_STENCIL_ATTACHMENT_BIT;
    case Access::copy_source: return VK_IMAGE_USAGE_TRANSFER_SRC_BIT;
    case Access::copy_target: return VK_IMAGE_USAGE_TRANSFER_DST_BIT;
    case Access::indirect_arguments: break;
  }
  return 0;
}

VkBufferUsageFlags buffer_usage_of(Access access) {
  switch (access) {
    case Access::storage_read:
    case Access::storage_write: return VK_BUFFER_USAGE_STORAGE_BUFFER_BIT;
    case Access::indirect_arguments: return VK_BUFFER_USAGE_INDIRECT_BUFFER_BIT;
    default: return 0;
  }
}

// A resource stands once in a pass: two accesses would need two layouts at the same time.
void add_use(PassNode& pass, const Use& use) {
  for (const Use& other : pass.uses)
    if (other.is_texture == use.is_texture && other.index == use.index) {
      DERMIS_ASSERT(other.access == use.access);
      return;
    }
  pass.uses.push_back(use);
}

}  // namespace

bool writes(Access access) {
  return access == Access::storage_write || access == Access::colour_target || access == Access::depth_target || access == Access::copy_target;
}

TextureId FramePlan::texture(std::string name, const gpu::TextureDesc& desc, Lifetime lifetime) {
  textures_.push_back({std::move(name), desc, lifetime});
  return {static_cast<std::uint32_t>(textures_.size() - 1)};
}

BufferId FramePlan::buffer(std::string name, const gpu::BufferDesc& desc, Lifetime lifetime) {
  buffers_.push_back({std::move(name), desc, lifetime});
  return {static_cast<std::uint32_t>(buffers_.size() - 1)};
}

void FramePlan::read_back(TextureId id) {
  DERMIS_ASSERT_LT(id.index, textures_.size());
  textures_[id.index].desc.usage |= VK_IMAGE_USAGE_TRANSFER_SRC_BIT;
}

TextureId Declare::create(std::string name, const gpu::TextureDesc& desc, Lifetime lifetime) {
  return plan_->texture(std::move(name), desc, lifetime);
}

BufferId Declare::create(std::string name, const gpu::BufferDesc& desc, Lifetime lifetime) {
  return plan_->buffer(std::move(name), desc, lifetime);
}

const gpu::TextureDesc& Declare::desc(TextureId id) const {
  DERMIS_ASSERT_LT(id.index, plan_->textures_.size());
  return plan_->textures_[id.index].desc;
}

void Declare::use(TextureId id, Access access) {
  DERMIS_ASSERT_LT(id.index, plan_->textures_.size());
  plan_->textures_[id.index].desc.usage |= usage_of(access);
  add_use(*pass_, {.is_texture = true, .index = id.index, .access = access});
}

void Declare::use(BufferId id, Access access) {
  DERMIS_ASSERT_LT(id.index, plan_->buffers_.size());
  plan_->buffers_[id.index].desc.usage |= buffer_usage_of(access);
  add_use(*pass_, {.is_texture = false, .index = id.index, .access = access});
}

}  // namespace dermis::frame
