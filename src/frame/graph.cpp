// SPDX-License-Identifier: MIT
#include "frame/graph.h"

#include <iterator>

namespace dermis::frame {
const AccessRow& row_of(Access access) {
  // In the order of Access. Stages 0 stands for the shader stages of the pass.
  static constexpr AccessRow rows[] = {
      {"samples", 0, VK_ACCESS_2_SHADER_SAMPLED_READ_BIT, 0, VK_IMAGE_LAYOUT_SHADER_READ_ONLY_OPTIMAL,
       VK_IMAGE_USAGE_SAMPLED_BIT, 0},
      {"reads", 0, VK_ACCESS_2_SHADER_STORAGE_READ_BIT, 0, VK_IMAGE_LAYOUT_GENERAL,
       VK_IMAGE_USAGE_STORAGE_BIT, VK_BUFFER_USAGE_STORAGE_BUFFER_BIT},
      {"writes", 0, VK_ACCESS_2_SHADER_STORAGE_READ_BIT, VK_ACCESS_2_SHADER_STORAGE_WRITE_BIT,
       VK_IMAGE_LAYOUT_GENERAL, VK_IMAGE_USAGE_STORAGE_BIT, VK_BUFFER_USAGE_STORAGE_BUFFER_BIT},
      {"renders to", VK_PIPELINE_STAGE_2_COLOR_ATTACHMENT_OUTPUT_BIT, VK_ACCESS_2_COLOR_ATTACHMENT_READ_BIT,
       VK_ACCESS_2_COLOR_ATTACHMENT_WRITE_BIT, VK_IMAGE_LAYOUT_COLOR_ATTACHMENT_OPTIMAL,
       VK_IMAGE_USAGE_COLOR_ATTACHMENT_BIT, 0},
      {"depth", VK_PIPELINE_STAGE_2_EARLY_FRAGMENT_TESTS_BIT | VK_PIPELINE_STAGE_2_LATE_FRAGMENT_TESTS_BIT,
       VK_ACCESS_2_DEPTH_STENCIL_ATTACHMENT_READ_BIT, VK_ACCESS_2_DEPTH_STENCIL_ATTACHMENT_WRITE_BIT,
       VK_IMAGE_LAYOUT_DEPTH_ATTACHMENT_OPTIMAL, VK_IMAGE_USAGE_DEPTH_STENCIL_ATTACHMENT_BIT, 0},
      {"copies from", VK_PIPELINE_STAGE_2_ALL_TRANSFER_BIT, VK_ACCESS_2_TRANSFER_READ_BIT, 0,
       VK_IMAGE_LAYOUT_TRANSFER_SRC_OPTIMAL, VK_IMAGE_USAGE_TRANSFER_SRC_BIT, 0},
      {"copies to", VK_PIPELINE_STAGE_2_ALL_TRANSFER_BIT, 0, VK_ACCESS_2_TRANSFER_WRITE_BIT,
       VK_IMAGE_LAYOUT_TRANSFER_DST_OPTIMAL, VK_IMAGE_USAGE_TRANSFER_DST_BIT, 0},
      {"arguments from", VK_PIPELINE_STAGE_2_DRAW_INDIRECT_BIT, VK_ACCESS_2_INDIRECT_COMMAND_READ_BIT, 0,
       VK_IMAGE_LAYOUT_UNDEFINED, 0, VK_BUFFER_USAGE_INDIRECT_BUFFER_BIT},
      {"indices from", VK_PIPELINE_STAGE_2_INDEX_INPUT_BIT, VK_ACCESS_2_INDEX_READ_BIT, 0,
       VK_IMAGE_LAYOUT_UNDEFINED, 0, VK_BUFFER_USAGE_INDEX_BUFFER_BIT},
  };

  static_assert(std::size(rows) == static_cast<std::size_t>(Access::indices) + 1);
  return rows[static_cast<std::size_t>(access)];
}

TextureId FrameGraph::texture(std::string name, const gpu::TextureDesc& desc, Lifetime lifetime) {
  textures_.push_back({std::move(name), desc, lifetime});
  return {static_cast<std::uint32_t>(textures_.size() - 1)};
}

BufferId FrameGraph::buffer(std::string name, const gpu::BufferDesc& desc, Lifetime lifetime) {
  buffers_.push_back({std::move(name), desc, lifetime});
  return {static_cast<std::uint32_t>(buffers_.size() - 1)};
}

void FrameGraph::read_back(TextureId id) {
  DERMIS_ASSERT_LT(id.index, textures_.size());
  textures_[id.index].desc.usage |= VK_IMAGE_USAGE_TRANSFER_SRC_BIT;
}

bool FrameGraph::stays_general(std::uint32_t texture) const {
  constexpr VkImageUsageFlags fixed = VK_IMAGE_USAGE_COLOR_ATTACHMENT_BIT |
                                      VK_IMAGE_USAGE_DEPTH_STENCIL_ATTACHMENT_BIT |
                                      VK_IMAGE_USAGE_TRANSFER_DST_BIT;
  const TextureNode& node = textures_[texture];
  return node.lifetime == Lifetime::transient && (node.desc.usage & fixed) == 0;
}

VkImageLayout FrameGraph::layout_in(std::uint32_t texture, Access access) const {
  return access == Access::sampled && stays_general(texture) ? VK_IMAGE_LAYOUT_GENERAL
                                                             : row_of(access).layout;
}

TextureId Declare::create(std::string name, const gpu::TextureDesc& desc, Lifetime lifetime) {
  return graph_->texture(std::move(name), desc, lifetime);
}

BufferId Declare::create(std::string name, const gpu::BufferDesc& desc, Lifetime lifetime) {
  return graph_->buffer(std::move(name), desc, lifetime);
}

const gpu::TextureDesc& Declare::desc(TextureId id) const {
  DERMIS_ASSERT_LT(id.index, graph_->textures_.size());
  return graph_->textures_[id.index].desc;
}

void Declare::use(const Use& use) {
  DERMIS_ASSERT_LT(use.index, use.is_texture ? graph_->textures_.size() : graph_->buffers_.size());
  const AccessRow& row = row_of(use.access);
  if (use.is_texture)
    graph_->textures_[use.index].desc.usage |= row.texture_usage;
  else
    graph_->buffers_[use.index].desc.usage |= row.buffer_usage;
  // A pass uses a resource only once: two accesses would need two layouts at the same time.
  for (const Use& other : pass_->uses)
    if (other.is_texture == use.is_texture && other.index == use.index) {
      DERMIS_ASSERT(other.access == use.access);
      return;
    }
  pass_->uses.push_back(use);
}

WrittenImages written_images(const FrameGraph& graph, const PassNode& pass) {
  WrittenImages written;
  for (const Use& use : pass.uses) {
    if (!use.is_texture || !writes(use.access)) continue;
    const gpu::TextureDesc& desc = graph.textures()[use.index].desc;
    written.texels += gpu::texels_of(desc);
    written.bytes += gpu::bytes_of(desc);
  }
  return written;
}

bool FrameKind::has(Runs runs) const {
  switch (runs) {
    case Runs::every_frame: return true;
    case Runs::once: return first;
    case Runs::when_changed: return first || changed;
    case Runs::for_statistics: return statistics;
  }
  return true;
}

}  // namespace dermis::frame
