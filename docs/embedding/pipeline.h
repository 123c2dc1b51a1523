// SPDX-License-Identifier: MIT
/// Graphics pipelines of the host, and what they read: the long structures of Vulkan with the choices of
/// these samples filled in. Nothing here concerns dermis.
#pragma once

#include <span>
#include <vector>

#include "device.h"

namespace host {

struct PipelineInfo {
  std::span<const std::uint32_t> vertex{};    ///< SPIR-V, entry point main
  std::span<const std::uint32_t> fragment{};  ///< empty: depth alone
  VkFormat colour_format = VK_FORMAT_UNDEFINED;
  VkFormat depth_format = VK_FORMAT_D32_SFLOAT;
  std::uint32_t samples = 1;
  std::vector<VkVertexInputBindingDescription> vertex_buffers{};
  std::vector<VkVertexInputAttributeDescription> attributes{};
  /// Bindings 0, 1, ... of set 0, one descriptor each; for both stages.
  std::vector<VkDescriptorType> descriptors{};
  std::uint32_t push_bytes = 0;                              ///< of both stages, from 0
  VkCompareOp compare = VK_COMPARE_OP_GREATER_OR_EQUAL;      ///< near is 1
  VkFrontFace front_face = VK_FRONT_FACE_COUNTER_CLOCKWISE;  ///< on the screen, y down
  VkCullModeFlags cull = VK_CULL_MODE_BACK_BIT;
};

/// Triangle lists; viewport and scissor are dynamic, as begin_rendering() sets them.
struct Pipeline {
  Owned<VkDescriptorSetLayout> set_layout;
  Owned<VkPipelineLayout> layout;
  Owned<VkPipeline> pipeline;
  std::vector<VkDescriptorType> descriptors;

  Pipeline(const Device& device, const PipelineInfo& info);
  void bind(VkCommandBuffer commands) const;
  void bind(VkCommandBuffer commands, VkDescriptorSet set) const;
  template <class Values>
  void push(VkCommandBuffer commands, const Values& values) const {
    vkCmdPushConstants(commands, layout.get(), VK_SHADER_STAGE_VERTEX_BIT | VK_SHADER_STAGE_FRAGMENT_BIT, 0,
                       sizeof(values), &values);
  }
};

/// What a binding holds: one of both.
struct Descriptor {
  VkDescriptorBufferInfo buffer{};
  VkDescriptorImageInfo image{};
};

/// Sets for a pipeline, one per frame in flight: a set must not change while a frame uses it.
class DescriptorSets {
 public:
  DescriptorSets(const Device& device, const Pipeline& pipeline, std::uint32_t frames_in_flight);
  /// Writes all bindings of the set of Frames::Frame::slot, and returns it.
  VkDescriptorSet write(std::uint32_t slot, std::span<const Descriptor> values) const;

 private:
  VkDevice device_;
  std::vector<VkDescriptorType> types_;
  Owned<VkDescriptorPool> pool_;
  std::vector<VkDescriptorSet> sets_;
};

/// Linear, without levels, clamped to the edge. With a comparison: for shadow maps.
Owned<VkSampler> make_sampler(const Device& device, std::optional<VkCompareOp> compare = {});

}  // namespace host
