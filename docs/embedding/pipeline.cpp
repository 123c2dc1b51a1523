// SPDX-License-Identifier: MIT
#include "pipeline.h"

namespace host {
namespace {

constexpr VkShaderStageFlags both_stages = VK_SHADER_STAGE_VERTEX_BIT | VK_SHADER_STAGE_FRAGMENT_BIT;

Owned<VkDescriptorSetLayout> make_set_layout(VkDevice device, std::span<const VkDescriptorType> types) {
  std::vector<VkDescriptorSetLayoutBinding> bindings;
  for (const VkDescriptorType type : types)
    bindings.push_back({static_cast<std::uint32_t>(bindings.size()), type, 1, both_stages, nullptr});
  VkDescriptorSetLayoutCreateInfo info{VK_STRUCTURE_TYPE_DESCRIPTOR_SET_LAYOUT_CREATE_INFO};
  info.bindingCount = static_cast<std::uint32_t>(bindings.size());
  info.pBindings = bindings.data();
  VkDescriptorSetLayout layout = VK_NULL_HANDLE;
  check(vkCreateDescriptorSetLayout(device, &info, nullptr, &layout), "vkCreateDescriptorSetLayout");
  return {device, layout, vkDestroyDescriptorSetLayout};
}

Owned<VkPipelineLayout> make_layout(VkDevice device, VkDescriptorSetLayout set, std::uint32_t push_bytes) {
  const VkPushConstantRange range{both_stages, 0, push_bytes};
  VkPipelineLayoutCreateInfo info{VK_STRUCTURE_TYPE_PIPELINE_LAYOUT_CREATE_INFO};
  info.setLayoutCount = 1;
  info.pSetLayouts = &set;
  info.pushConstantRangeCount = push_bytes ? 1 : 0;
  info.pPushConstantRanges = &range;
  VkPipelineLayout layout = VK_NULL_HANDLE;
  check(vkCreatePipelineLayout(device, &info, nullptr, &layout), "vkCreatePipelineLayout");
  return {device, layout, vkDestroyPipelineLayout};
}

Owned<VkShaderModule> make_module(VkDevice device, std::span<const std::uint32_t> words) {
  VkShaderModuleCreateInfo info{VK_STRUCTURE_TYPE_SHADER_MODULE_CREATE_INFO};
  info.codeSize = words.size_bytes();
  info.pCode = words.data();
  VkShaderModule module = VK_NULL_HANDLE;
  check(vkCreateShaderModule(device, &info, nullptr, &module), "vkCreateShaderModule");
  return {device, module, vkDestroyShaderModule};
}

VkPipelineShaderStageCreateInfo stage_of(VkShaderStageFlagBits stage, VkShaderModule module) {
  VkPipelineShaderStageCreateInfo info{VK_STRUCTURE_TYPE_PIPELINE_SHADER_STAGE_CREATE_INFO};
  info.stage = stage;
  info.module = module;
  info.pName = "main";
  return info;
}

Owned<VkPipeline> make_pipeline(VkDevice device, VkPipelineLayout layout, const PipelineInfo& wanted) {
  const bool draws_colour = !wanted.fragment.empty();
  const Owned<VkShaderModule> vertex = make_module(device, wanted.vertex);
  Owned<VkShaderModule> fragment;
  if (draws_colour) fragment = make_module(device, wanted.fragment);
  const std::array stages{stage_of(VK_SHADER_STAGE_VERTEX_BIT, vertex.get()),
                          stage_of(VK_SHADER_STAGE_FRAGMENT_BIT, fragment.get())};

  VkPipelineVertexInputStateCreateInfo input{VK_STRUCTURE_TYPE_PIPELINE_VERTEX_INPUT_STATE_CREATE_INFO};
  input.vertexBindingDescriptionCount = static_cast<std::uint32_t>(wanted.vertex_buffers.size());
  input.pVertexBindingDescriptions = wanted.vertex_buffers.data();
  input.vertexAttributeDescriptionCount = static_cast<std::uint32_t>(wanted.attributes.size());
  input.pVertexAttributeDescriptions = wanted.attributes.data();
  VkPipelineInputAssemblyStateCreateInfo assembly{
      VK_STRUCTURE_TYPE_PIPELINE_INPUT_ASSEMBLY_STATE_CREATE_INFO};
  assembly.topology = VK_PRIMITIVE_TOPOLOGY_TRIANGLE_LIST;
  VkPipelineViewportStateCreateInfo viewport{VK_STRUCTURE_TYPE_PIPELINE_VIEWPORT_STATE_CREATE_INFO};
  viewport.viewportCount = viewport.scissorCount = 1;
  VkPipelineRasterizationStateCreateInfo raster{VK_STRUCTURE_TYPE_PIPELINE_RASTERIZATION_STATE_CREATE_INFO};
  raster.cullMode = wanted.cull;
  raster.frontFace = wanted.front_face;
  raster.lineWidth = 1;
  VkPipelineMultisampleStateCreateInfo samples{VK_STRUCTURE_TYPE_PIPELINE_MULTISAMPLE_STATE_CREATE_INFO};
  samples.rasterizationSamples = static_cast<VkSampleCountFlagBits>(wanted.samples);
  VkPipelineDepthStencilStateCreateInfo depth{VK_STRUCTURE_TYPE_PIPELINE_DEPTH_STENCIL_STATE_CREATE_INFO};
  depth.depthTestEnable = depth.depthWriteEnable = VK_TRUE;
  depth.depthCompareOp = wanted.compare;

  VkPipelineColorBlendAttachmentState opaque{};
  opaque.colorWriteMask = 0xf;
  VkPipelineColorBlendStateCreateInfo blend{VK_STRUCTURE_TYPE_PIPELINE_COLOR_BLEND_STATE_CREATE_INFO};
  blend.attachmentCount = draws_colour ? 1 : 0;
  blend.pAttachments = &opaque;
  constexpr std::array dynamic_states{VK_DYNAMIC_STATE_VIEWPORT, VK_DYNAMIC_STATE_SCISSOR};
  VkPipelineDynamicStateCreateInfo dynamic{VK_STRUCTURE_TYPE_PIPELINE_DYNAMIC_STATE_CREATE_INFO};
  dynamic.dynamicStateCount = dynamic_states.size();
  dynamic.pDynamicStates = dynamic_states.data();
  VkPipelineRenderingCreateInfo rendering{VK_STRUCTURE_TYPE_PIPELINE_RENDERING_CREATE_INFO};
  rendering.colorAttachmentCount = draws_colour ? 1 : 0;
  rendering.pColorAttachmentFormats = &wanted.colour_format;
  rendering.depthAttachmentFormat = wanted.depth_format;

  VkGraphicsPipelineCreateInfo info{VK_STRUCTURE_TYPE_GRAPHICS_PIPELINE_CREATE_INFO};
  info.pNext = &rendering;
  info.stageCount = draws_colour ? 2 : 1;
  info.pStages = stages.data();
  info.pVertexInputState = &input;
  info.pInputAssemblyState = &assembly;
  info.pViewportState = &viewport;
  info.pRasterizationState = &raster;
  info.pMultisampleState = &samples;
  info.pDepthStencilState = &depth;
  info.pColorBlendState = &blend;
  info.pDynamicState = &dynamic;
  info.layout = layout;
  VkPipeline pipeline = VK_NULL_HANDLE;
  check(vkCreateGraphicsPipelines(device, VK_NULL_HANDLE, 1, &info, nullptr, &pipeline),
        "vkCreateGraphicsPipelines");
  return {device, pipeline, vkDestroyPipeline};
}

}  // namespace

Pipeline::Pipeline(const Device& device, const PipelineInfo& info)
    : set_layout(make_set_layout(device.handle(), info.descriptors)),
      layout(make_layout(device.handle(), set_layout.get(), info.push_bytes)),
      pipeline(make_pipeline(device.handle(), layout.get(), info)),
      descriptors(info.descriptors) {}

void Pipeline::bind(VkCommandBuffer commands) const {
  vkCmdBindPipeline(commands, VK_PIPELINE_BIND_POINT_GRAPHICS, pipeline.get());
}

void Pipeline::bind(VkCommandBuffer commands, VkDescriptorSet set) const {
  bind(commands);
  vkCmdBindDescriptorSets(commands, VK_PIPELINE_BIND_POINT_GRAPHICS, layout.get(), 0, 1, &set, 0, nullptr);
}

DescriptorSets::DescriptorSets(const Device& device, const Pipeline& pipeline, std::uint32_t frames_in_flight)
    : device_(device.handle()), types_(pipeline.descriptors), sets_(frames_in_flight) {
  std::vector<VkDescriptorPoolSize> sizes;
  for (const VkDescriptorType type : types_) sizes.push_back({type, frames_in_flight});
  VkDescriptorPoolCreateInfo info{VK_STRUCTURE_TYPE_DESCRIPTOR_POOL_CREATE_INFO};
  info.maxSets = frames_in_flight;
  info.poolSizeCount = static_cast<std::uint32_t>(sizes.size());
  info.pPoolSizes = sizes.data();
  VkDescriptorPool pool = VK_NULL_HANDLE;
  check(vkCreateDescriptorPool(device_, &info, nullptr, &pool), "vkCreateDescriptorPool");
  pool_ = {device_, pool, vkDestroyDescriptorPool};

  const std::vector<VkDescriptorSetLayout> layouts(frames_in_flight, pipeline.set_layout.get());
  VkDescriptorSetAllocateInfo allocate{VK_STRUCTURE_TYPE_DESCRIPTOR_SET_ALLOCATE_INFO};
  allocate.descriptorPool = pool;
  allocate.descriptorSetCount = frames_in_flight;
  allocate.pSetLayouts = layouts.data();
  check(vkAllocateDescriptorSets(device_, &allocate, sets_.data()), "vkAllocateDescriptorSets");
}

VkDescriptorSet DescriptorSets::write(std::uint32_t slot, std::span<const Descriptor> values) const {
  std::vector<VkWriteDescriptorSet> writes;
  for (std::uint32_t i = 0; i < values.size(); ++i) {
    VkWriteDescriptorSet write{VK_STRUCTURE_TYPE_WRITE_DESCRIPTOR_SET};
    write.dstSet = sets_.at(slot);
    write.dstBinding = i;
    write.descriptorCount = 1;
    write.descriptorType = types_.at(i);
    write.pBufferInfo = &values[i].buffer;
    write.pImageInfo = &values[i].image;
    writes.push_back(write);
  }
  vkUpdateDescriptorSets(device_, static_cast<std::uint32_t>(writes.size()), writes.data(), 0, nullptr);
  return sets_[slot];
}

Owned<VkSampler> make_sampler(const Device& device, std::optional<VkCompareOp> compare) {
  VkSamplerCreateInfo info{VK_STRUCTURE_TYPE_SAMPLER_CREATE_INFO};
  info.magFilter = info.minFilter = VK_FILTER_LINEAR;
  info.addressModeU = info.addressModeV = info.addressModeW = VK_SAMPLER_ADDRESS_MODE_CLAMP_TO_EDGE;
  info.compareEnable = compare ? VK_TRUE : VK_FALSE;
  info.compareOp = compare.value_or(VK_COMPARE_OP_NEVER);
  VkSampler sampler = VK_NULL_HANDLE;
  check(vkCreateSampler(device.handle(), &info, nullptr, &sampler), "vkCreateSampler");
  return {device.handle(), sampler, vkDestroySampler};
}

}  // namespace host
