// SPDX-License-Identifier: MIT
#include "gpu/pipelines.h"

#include <algorithm>
#include <chrono>

#include "base/core/assert.h"
#include "base/core/cache.h"
#include "base/core/error.h"
#include "gpu/device.h"
#include "gpu/formats.h"
#include "gpu/pipeline_cache.h"
#include "gpu/replaced_shader.h"

namespace dermis::gpu {
namespace {

using Clock = std::chrono::steady_clock;

std::string text_of(const Constants& constants) {
  std::string text;
  for (const auto& [name, value] : constants) text += fmt::format(" {}={}", name, value);
  return text;
}

/// One shader with its specialisation constants, ready for a pipeline. Must not move: the structures point at
/// each other.
class Stage {
 public:
  Stage(Device& device, VkShaderStageFlagBits stage, const std::string& name,
        std::span<const std::uint32_t> spirv, const Constants& constants)
      : device_(&device), interface_(reflect(spirv, name)) {
    VkShaderModuleCreateInfo module_info{};
    module_info.sType = VK_STRUCTURE_TYPE_SHADER_MODULE_CREATE_INFO;
    module_info.codeSize = spirv.size_bytes();
    module_info.pCode = spirv.data();
    check(device.vk().vkCreateShaderModule(device.handle(), &module_info, nullptr, &info_.module),
          "vkCreateShaderModule");
    device.set_name(VK_OBJECT_TYPE_SHADER_MODULE, reinterpret_cast<std::uint64_t>(info_.module), name);
    specialise(constants);
    info_.sType = VK_STRUCTURE_TYPE_PIPELINE_SHADER_STAGE_CREATE_INFO;
    info_.stage = stage;
    info_.pName = "main";
    info_.pSpecializationInfo = &specialisation_;
  }
  Stage(const Stage&) = delete;
  Stage& operator=(const Stage&) = delete;
  ~Stage() { device_->vk().vkDestroyShaderModule(device_->handle(), info_.module, nullptr); }

  const VkPipelineShaderStageCreateInfo& info() const { return info_; }
  const ShaderInterface& interface() const { return interface_; }

 private:
  void specialise(const Constants& constants) {
    for (const auto& [name, value] : constants) {
      const auto declared =
          std::ranges::find(interface_.constants, name, &std::pair<std::string, std::uint32_t>::first);
      if (declared == interface_.constants.end()) continue;
      entries_.push_back({declared->second,
                          static_cast<std::uint32_t>(values_.size() * sizeof(std::uint32_t)),
                          sizeof(std::uint32_t)});
      values_.push_back(value);
      for (std::size_t axis = 0; axis < 3; ++axis)
        if (interface_.workgroup_constants[axis] == declared->second) interface_.workgroup[axis] = value;
    }
    specialisation_ = {static_cast<std::uint32_t>(entries_.size()), entries_.data(),
                       values_.size() * sizeof(std::uint32_t), values_.data()};
  }

  Device* device_;
  ShaderInterface interface_;
  std::vector<VkSpecializationMapEntry> entries_;
  std::vector<std::uint32_t> values_;
  VkSpecializationInfo specialisation_{};
  VkPipelineShaderStageCreateInfo info_{};
};

void check_declared(const std::string& pipeline, const ShaderInterface& interface,
                    const Constants& constants) {
  for (const auto& constant_given : constants) {
    const std::string& name = constant_given.first;
    const bool declared =
        std::ranges::any_of(interface.constants, [&](const auto& c) { return c.first == name; });
    if (declared) continue;
    std::vector<std::string> known;
    for (const auto& constant : interface.constants) known.push_back(constant.first);
    assertion_failed("the shader declares the specialisation constant",
                     fmt::format("{}: '{}'; declared: {}", pipeline, name, fmt::join(known, ", ")), __FILE__,
                     __LINE__);
  }
}

void merge(ShaderInterface& into, const ShaderInterface& other, const std::string& pipeline) {
  for (const BindingSlot& slot : other.bindings) {
    const auto same = std::ranges::find(into.bindings, slot.binding, &BindingSlot::binding);
    if (same == into.bindings.end()) {
      into.bindings.push_back(slot);
    } else if (same->kind != slot.kind || same->count != slot.count) {
      assertion_failed("both stages agree on a binding",
                       fmt::format("{}: binding {} '{}'", pipeline, slot.binding, slot.name), __FILE__,
                       __LINE__);
    }
  }
  std::ranges::sort(into.bindings, {}, &BindingSlot::binding);
  into.push_bytes = std::max(into.push_bytes, other.push_bytes);
  for (const auto& constant : other.constants)
    if (std::ranges::find(into.constants, constant) == into.constants.end())
      into.constants.push_back(constant);
}

std::string key_of(const GraphicsDesc& desc) {
  std::vector<int> formats(desc.colour_formats.begin(), desc.colour_formats.end());
  return fmt::format("{}|{}|{}|{}|{}|{}|{}|{}|{}{}|{}|{}|{}|{}|{}", desc.vertex, desc.fragment,
                     text_of(desc.constants), fmt::join(formats, ","), static_cast<int>(desc.depth_format),
                     desc.samples, static_cast<int>(desc.blend), static_cast<int>(desc.cull), desc.depth_test,
                     desc.depth_write, static_cast<int>(desc.depth_compare), desc.depth_clamp,
                     desc.depth_bias, desc.depth_bias_slope, desc.alpha_to_coverage);
}

/// The fixed functions of a graphics pipeline. Must not move: the structures point at each other.
struct FixedFunctions {
  explicit FixedFunctions(const GraphicsDesc& desc);
  FixedFunctions(const FixedFunctions&) = delete;
  FixedFunctions& operator=(const FixedFunctions&) = delete;
  void fill(VkGraphicsPipelineCreateInfo& info) const;

  VkPipelineRenderingCreateInfo rendering{};
  VkPipelineVertexInputStateCreateInfo vertex_input{};
  VkPipelineInputAssemblyStateCreateInfo assembly{};
  VkPipelineViewportStateCreateInfo viewport{};
  VkPipelineRasterizationStateCreateInfo raster{};
  VkPipelineMultisampleStateCreateInfo samples{};
  VkPipelineDepthStencilStateCreateInfo depth{};
  std::vector<VkPipelineColorBlendAttachmentState> attachments;
  VkPipelineColorBlendStateCreateInfo blend{};
  std::array<VkDynamicState, 3> dynamic_states{VK_DYNAMIC_STATE_VIEWPORT, VK_DYNAMIC_STATE_SCISSOR,
                                               VK_DYNAMIC_STATE_CULL_MODE};
  VkPipelineDynamicStateCreateInfo dynamic{};
};

VkPipelineColorBlendAttachmentState blend_of(Blend blend) {
  VkPipelineColorBlendAttachmentState state{};
  state.colorWriteMask = VK_COLOR_COMPONENT_R_BIT | VK_COLOR_COMPONENT_G_BIT | VK_COLOR_COMPONENT_B_BIT |
                         VK_COLOR_COMPONENT_A_BIT;
  if (blend == Blend::none) return state;
  state.blendEnable = VK_TRUE;
  state.srcColorBlendFactor = state.srcAlphaBlendFactor = VK_BLEND_FACTOR_ONE;
  state.dstColorBlendFactor = state.dstAlphaBlendFactor = VK_BLEND_FACTOR_ONE_MINUS_SRC_ALPHA;
  state.colorBlendOp = state.alphaBlendOp = VK_BLEND_OP_ADD;
  return state;
}

VkCullModeFlags cull_of(Cull cull) {
  switch (cull) {
    case Cull::none: return VK_CULL_MODE_NONE;
    case Cull::back: return VK_CULL_MODE_BACK_BIT;
    case Cull::front: return VK_CULL_MODE_FRONT_BIT;
  }
  return VK_CULL_MODE_NONE;
}

FixedFunctions::FixedFunctions(const GraphicsDesc& desc) {
  rendering.sType = VK_STRUCTURE_TYPE_PIPELINE_RENDERING_CREATE_INFO;
  rendering.colorAttachmentCount = static_cast<std::uint32_t>(desc.colour_formats.size());
  rendering.pColorAttachmentFormats = desc.colour_formats.data();
  rendering.depthAttachmentFormat = desc.depth_format;

  vertex_input.sType = VK_STRUCTURE_TYPE_PIPELINE_VERTEX_INPUT_STATE_CREATE_INFO;
  assembly.sType = VK_STRUCTURE_TYPE_PIPELINE_INPUT_ASSEMBLY_STATE_CREATE_INFO;
  assembly.topology = VK_PRIMITIVE_TOPOLOGY_TRIANGLE_LIST;
  viewport.sType = VK_STRUCTURE_TYPE_PIPELINE_VIEWPORT_STATE_CREATE_INFO;
  viewport.viewportCount = viewport.scissorCount = 1;

  raster.sType = VK_STRUCTURE_TYPE_PIPELINE_RASTERIZATION_STATE_CREATE_INFO;
  raster.depthClampEnable = desc.depth_clamp;
  raster.frontFace = VK_FRONT_FACE_COUNTER_CLOCKWISE;
  raster.depthBiasEnable = desc.depth_bias != 0 || desc.depth_bias_slope != 0;
  raster.depthBiasConstantFactor = desc.depth_bias;
  raster.depthBiasSlopeFactor = desc.depth_bias_slope;
  raster.lineWidth = 1;

  samples.sType = VK_STRUCTURE_TYPE_PIPELINE_MULTISAMPLE_STATE_CREATE_INFO;
  samples.rasterizationSamples = static_cast<VkSampleCountFlagBits>(desc.samples);
  samples.alphaToCoverageEnable = desc.alpha_to_coverage;
  depth.sType = VK_STRUCTURE_TYPE_PIPELINE_DEPTH_STENCIL_STATE_CREATE_INFO;
  // Vulkan writes depth only if the depth test is on.
  depth.depthTestEnable = desc.depth_test || desc.depth_write;
  depth.depthWriteEnable = desc.depth_write;
  depth.depthCompareOp = desc.depth_test ? desc.depth_compare : VK_COMPARE_OP_ALWAYS;

  attachments.assign(desc.colour_formats.size(), blend_of(desc.blend));
  blend.sType = VK_STRUCTURE_TYPE_PIPELINE_COLOR_BLEND_STATE_CREATE_INFO;
  blend.attachmentCount = static_cast<std::uint32_t>(attachments.size());
  blend.pAttachments = attachments.data();
  dynamic.sType = VK_STRUCTURE_TYPE_PIPELINE_DYNAMIC_STATE_CREATE_INFO;
  dynamic.dynamicStateCount = static_cast<std::uint32_t>(dynamic_states.size());
  dynamic.pDynamicStates = dynamic_states.data();
}

void FixedFunctions::fill(VkGraphicsPipelineCreateInfo& info) const {
  info.sType = VK_STRUCTURE_TYPE_GRAPHICS_PIPELINE_CREATE_INFO;
  info.pNext = &rendering;
  info.pVertexInputState = &vertex_input;
  info.pInputAssemblyState = &assembly;
  info.pViewportState = &viewport;
  info.pRasterizationState = &raster;
  info.pMultisampleState = &samples;
  info.pDepthStencilState = &depth;
  info.pColorBlendState = &blend;
  info.pDynamicState = &dynamic;
}

// Every device allows so many (maxPushDescriptors), however many the one at hand does.
constexpr std::uint32_t most_push_descriptors = 32;

VkSamplerAddressMode address_of(Address address) {
  switch (address) {
    case Address::repeat: return VK_SAMPLER_ADDRESS_MODE_REPEAT;
    case Address::clamp: return VK_SAMPLER_ADDRESS_MODE_CLAMP_TO_EDGE;
    case Address::mirror: return VK_SAMPLER_ADDRESS_MODE_MIRRORED_REPEAT;
  }
  return VK_SAMPLER_ADDRESS_MODE_CLAMP_TO_EDGE;
}

}  // namespace

struct PipelineLibrary::State {
  /// A pipeline and the objects that it owns.
  struct Entry {
    Pipeline pipeline;
    VkDescriptorSetLayout set_layout = VK_NULL_HANDLE;
    bool owns = true;  ///< else another entry does
  };
  Device* device = nullptr;
  ShaderSource shaders;
  std::filesystem::path cache_file;
  ShaderSource replaced;  ///< by a host; may be empty
  VkPipelineCache cache = VK_NULL_HANDLE;
  bool owns_cache = true;
  std::vector<std::byte> loaded;  ///< content of the cache file
  bool cannot_save = false;       ///< once is enough, however many frames are prepared
  std::map<std::string, std::unique_ptr<Entry>> entries;
  std::vector<std::pair<SamplerDesc, VkSampler>> samplers;
  double creation_ms = 0;

  std::span<const std::uint32_t> code(const std::string& name) const {
    const std::span<const std::uint32_t> spirv = shaders(name);
    if (spirv.empty()) assertion_failed("there is a shader of this name", name, __FILE__, __LINE__);
    const std::span<const std::uint32_t> other = replaced ? replaced(name) : std::span<const std::uint32_t>();
    if (other.empty()) return spirv;
    check_replacement("vulkan::Host::find_shader", name, spirv, other);
    return other;
  }
  void create_layout(Entry& entry, VkShaderStageFlags stages);
  const Pipeline& keep(const std::string& key, std::unique_ptr<Entry> entry, Clock::time_point start);
  void destroy(const Entry& entry) const;
  void create_cache();
};

void PipelineLibrary::State::create_layout(Entry& entry, VkShaderStageFlags stages) {
  const ShaderInterface& interface = entry.pipeline.interface;
  if (interface.push_bytes > device->limits().max_push_bytes)
    throw device_error("'{}' needs {} bytes of push constants, {} has {}", entry.pipeline.name,
                       interface.push_bytes, device->summary().name, device->limits().max_push_bytes);

  std::vector<VkDescriptorSetLayoutBinding> bindings;
  std::uint32_t descriptors = 0;
  for (const BindingSlot& slot : interface.bindings) {
    bindings.push_back({slot.binding, descriptor_type(slot.kind), slot.count, stages, nullptr});
    descriptors += slot.count;
  }
  DERMIS_ASSERT_LE(descriptors, most_push_descriptors);
  VkDescriptorSetLayoutCreateInfo set_info{};
  set_info.sType = VK_STRUCTURE_TYPE_DESCRIPTOR_SET_LAYOUT_CREATE_INFO;
  set_info.flags = VK_DESCRIPTOR_SET_LAYOUT_CREATE_PUSH_DESCRIPTOR_BIT_KHR;
  set_info.bindingCount = static_cast<std::uint32_t>(bindings.size());
  set_info.pBindings = bindings.data();
  check(device->vk().vkCreateDescriptorSetLayout(device->handle(), &set_info, nullptr, &entry.set_layout),
        "vkCreateDescriptorSetLayout");

  const VkPushConstantRange push{entry.pipeline.push_stages, 0, interface.push_bytes};
  VkPipelineLayoutCreateInfo info{};
  info.sType = VK_STRUCTURE_TYPE_PIPELINE_LAYOUT_CREATE_INFO;
  info.setLayoutCount = 1;
  info.pSetLayouts = &entry.set_layout;
  info.pushConstantRangeCount = interface.push_bytes > 0 ? 1 : 0;
  info.pPushConstantRanges = &push;
  check(device->vk().vkCreatePipelineLayout(device->handle(), &info, nullptr, &entry.pipeline.layout),
        "vkCreatePipelineLayout");
}

void PipelineLibrary::State::destroy(const Entry& entry) const {
  if (!entry.owns) return;
  device->vk().vkDestroyPipeline(device->handle(), entry.pipeline.handle, nullptr);
  device->vk().vkDestroyPipelineLayout(device->handle(), entry.pipeline.layout, nullptr);
  device->vk().vkDestroyDescriptorSetLayout(device->handle(), entry.set_layout, nullptr);
}

const Pipeline& PipelineLibrary::State::keep(const std::string& key, std::unique_ptr<Entry> entry,
                                             Clock::time_point start) {
  device->set_name(VK_OBJECT_TYPE_PIPELINE, reinterpret_cast<std::uint64_t>(entry->pipeline.handle),
                   entry->pipeline.name);
  creation_ms += std::chrono::duration<double, std::milli>(Clock::now() - start).count();
  return (entries[key] = std::move(entry))->pipeline;
}

void PipelineLibrary::State::create_cache() {
  if (!cache_file.empty()) loaded = load_pipeline_cache(cache_file, device->properties());
  VkPipelineCacheCreateInfo info{};
  info.sType = VK_STRUCTURE_TYPE_PIPELINE_CACHE_CREATE_INFO;
  info.initialDataSize = loaded.size();
  info.pInitialData = loaded.data();
  check(device->vk().vkCreatePipelineCache(device->handle(), &info, nullptr, &cache),
        "vkCreatePipelineCache");
}

PipelineLibrary::PipelineLibrary(Device& device, ShaderSource shaders, std::filesystem::path cache_file)
    : PipelineLibrary(device, std::move(shaders), std::move(cache_file), VK_NULL_HANDLE, {}) {}

PipelineLibrary::PipelineLibrary(Device& device, ShaderSource shaders, std::filesystem::path cache_file,
                                 VkPipelineCache of_host, ShaderSource replaced)
    : state_(std::make_unique<State>()) {
  state_->device = &device;
  state_->shaders = std::move(shaders);
  state_->replaced = std::move(replaced);
  state_->owns_cache = of_host == VK_NULL_HANDLE;
  if (state_->owns_cache) {
    state_->cache_file = std::move(cache_file);
    state_->create_cache();
  } else {
    state_->cache = of_host;
  }
}

PipelineLibrary::~PipelineLibrary() {
  Device& device = *state_->device;
  if (state_->owns_cache) device.vk().vkDestroyPipelineCache(device.handle(), state_->cache, nullptr);
  device.retire([state = std::shared_ptr<State>(std::move(state_))] {
    for (const auto& [key, entry] : state->entries) state->destroy(*entry);
    for (const auto& [desc, sampler] : state->samplers)
      state->device->vk().vkDestroySampler(state->device->handle(), sampler, nullptr);
  });
}

const Pipeline& PipelineLibrary::compute(const std::string& shader, const Constants& constants) {
  State& s = *state_;
  const std::string key = shader + text_of(constants);
  if (const auto found = s.entries.find(key); found != s.entries.end()) return found->second->pipeline;

  const auto start = Clock::now();
  const Stage stage(*s.device, VK_SHADER_STAGE_COMPUTE_BIT, shader, s.code(shader), constants);
  auto entry = std::make_unique<State::Entry>();
  Pipeline& pipeline = entry->pipeline;
  pipeline.name = key;
  pipeline.interface = stage.interface();
  pipeline.push_stages = pipeline.interface.push_bytes > 0 ? VK_SHADER_STAGE_COMPUTE_BIT : 0;
  check_declared(key, pipeline.interface, constants);

  const auto& size = pipeline.interface.workgroup;
  if (std::uint64_t{size[0]} * size[1] * size[2] > s.device->limits().max_workgroup_threads)
    throw device_error("'{}' needs workgroups of {}x{}x{}, {} allows {} threads", key, size[0], size[1],
                       size[2], s.device->summary().name, s.device->limits().max_workgroup_threads);

  try {
    s.create_layout(*entry, VK_SHADER_STAGE_COMPUTE_BIT);
    VkComputePipelineCreateInfo info{};
    info.sType = VK_STRUCTURE_TYPE_COMPUTE_PIPELINE_CREATE_INFO;
    info.stage = stage.info();
    info.layout = pipeline.layout;
    check(s.device->vk().vkCreateComputePipelines(s.device->handle(), s.cache, 1, &info, nullptr,
                                                  &pipeline.handle),
          "vkCreateComputePipelines");
    ++s.device->counters().pipelines;
  } catch (...) {
    s.destroy(*entry);
    throw;
  }

  return s.keep(key, std::move(entry), start);
}

const Pipeline& PipelineLibrary::graphics(const GraphicsDesc& desc) {
  State& s = *state_;
  const std::string key = key_of(desc);
  if (const auto found = s.entries.find(key); found != s.entries.end()) return found->second->pipeline;
  if (desc.cull != Cull::none) {
    // The culled face is dynamic state: a driver compiles the shaders once for all of it.
    GraphicsDesc unculled = desc;
    unculled.cull = Cull::none;
    auto entry = std::make_unique<State::Entry>(State::Entry{.pipeline = graphics(unculled), .owns = false});
    entry->pipeline.cull_mode = cull_of(desc.cull);
    return (s.entries[key] = std::move(entry))->pipeline;
  }

  const auto start = Clock::now();
  auto entry = std::make_unique<State::Entry>();
  Pipeline& pipeline = entry->pipeline;
  pipeline.bind_point = VK_PIPELINE_BIND_POINT_GRAPHICS;
  pipeline.name = desc.vertex + (desc.fragment.empty() ? "" : " " + desc.fragment) + text_of(desc.constants);

  std::vector<std::unique_ptr<Stage>> stages;
  stages.push_back(std::make_unique<Stage>(*s.device, VK_SHADER_STAGE_VERTEX_BIT, desc.vertex,
                                           s.code(desc.vertex), desc.constants));
  if (!desc.fragment.empty())
    stages.push_back(std::make_unique<Stage>(*s.device, VK_SHADER_STAGE_FRAGMENT_BIT, desc.fragment,
                                             s.code(desc.fragment), desc.constants));

  std::vector<VkPipelineShaderStageCreateInfo> infos;
  VkShaderStageFlags all = 0;
  for (const auto& stage : stages) {
    merge(pipeline.interface, stage->interface(), pipeline.name);
    infos.push_back(stage->info());
    all |= static_cast<VkShaderStageFlags>(stage->info().stage);
    if (stage->interface().push_bytes > 0)
      pipeline.push_stages |= static_cast<VkShaderStageFlags>(stage->info().stage);
  }
  check_declared(pipeline.name, pipeline.interface, desc.constants);

  const FixedFunctions fixed(desc);
  try {
    s.create_layout(*entry, all);
    VkGraphicsPipelineCreateInfo info{};
    fixed.fill(info);
    info.stageCount = static_cast<std::uint32_t>(infos.size());
    info.pStages = infos.data();
    info.layout = pipeline.layout;
    check(s.device->vk().vkCreateGraphicsPipelines(s.device->handle(), s.cache, 1, &info, nullptr,
                                                   &pipeline.handle),
          "vkCreateGraphicsPipelines");
    ++s.device->counters().pipelines;
  } catch (...) {
    s.destroy(*entry);
    throw;
  }

  return s.keep(key, std::move(entry), start);
}

VkSampler PipelineLibrary::sampler(const SamplerDesc& desc) {
  State& s = *state_;
  for (const auto& [known, sampler] : s.samplers)
    if (known == desc) return sampler;

  VkSamplerCreateInfo info{};
  info.sType = VK_STRUCTURE_TYPE_SAMPLER_CREATE_INFO;
  info.magFilter = info.minFilter = desc.filter == Filter::linear ? VK_FILTER_LINEAR : VK_FILTER_NEAREST;
  info.mipmapMode =
      desc.filter == Filter::linear ? VK_SAMPLER_MIPMAP_MODE_LINEAR : VK_SAMPLER_MIPMAP_MODE_NEAREST;
  info.addressModeU = address_of(desc.u);
  info.addressModeV = address_of(desc.v);
  info.addressModeW = VK_SAMPLER_ADDRESS_MODE_CLAMP_TO_EDGE;
  info.compareEnable = desc.compare_greater;
  info.compareOp = VK_COMPARE_OP_GREATER_OR_EQUAL;
  info.maxAnisotropy = std::min(desc.max_anisotropy, s.device->limits().max_anisotropy);
  info.anisotropyEnable = info.maxAnisotropy > 1;
  info.maxLod = VK_LOD_CLAMP_NONE;

  VkSampler sampler = VK_NULL_HANDLE;
  check(s.device->vk().vkCreateSampler(s.device->handle(), &info, nullptr, &sampler), "vkCreateSampler");
  s.samplers.emplace_back(desc, sampler);
  return sampler;
}

void PipelineLibrary::save_cache() const {
  State& s = *state_;
  if (s.cache_file.empty() || s.cannot_save) return;
  std::size_t bytes = 0;
  check(s.device->vk().vkGetPipelineCacheData(s.device->handle(), s.cache, &bytes, nullptr),
        "vkGetPipelineCacheData");
  std::vector<std::byte> data(bytes);
  check(s.device->vk().vkGetPipelineCacheData(s.device->handle(), s.cache, &bytes, data.data()),
        "vkGetPipelineCacheData");
  data.resize(bytes);
  if (data != s.loaded || s.loaded.empty())
    s.cannot_save = !save_pipeline_cache(s.cache_file, s.device->properties(), data);
}

double PipelineLibrary::creation_ms() const { return state_->creation_ms; }
Device& PipelineLibrary::device() { return *state_->device; }

std::filesystem::path default_pipeline_cache() {
  const std::filesystem::path folder = cache::default_folder();
  return folder.empty() ? folder : folder / "pipelines.bin";
}

}  // namespace dermis::gpu
