// SPDX-License-Identifier: MIT
#include <spirv_cross/spirv_cross_c.h>

#include <algorithm>

#include "base/core/assert.h"
#include "gpu/pipelines.h"

namespace dermis::gpu {
namespace {

/// Reports a faulty shader. Shaders are compiled with this library, so it is our bug.
[[noreturn]] void bad_shader(const std::string& name, const std::string& what) {
  assertion_failed("shader can be reflected", fmt::format("{}: {}", name, what), __FILE__, __LINE__);
}

class Reflection {
 public:
  Reflection(std::span<const std::uint32_t> spirv, const std::string& name) : name_(name) {
    need(spvc_context_create(&context_));
    spvc_parsed_ir ir = nullptr;
    need(spvc_context_parse_spirv(context_, spirv.data(), spirv.size(), &ir));
    need(spvc_context_create_compiler(context_, SPVC_BACKEND_NONE, ir, SPVC_CAPTURE_MODE_TAKE_OWNERSHIP,
                                      &compiler_));
    need(spvc_compiler_create_shader_resources(compiler_, &resources_));
  }
  Reflection(const Reflection&) = delete;
  Reflection& operator=(const Reflection&) = delete;
  ~Reflection() { spvc_context_destroy(context_); }

  ShaderInterface read() {
    ShaderInterface result;
    add(result, SPVC_RESOURCE_TYPE_STORAGE_BUFFER, BindingKind::storage_buffer);
    add(result, SPVC_RESOURCE_TYPE_UNIFORM_BUFFER, BindingKind::uniform_buffer);
    add(result, SPVC_RESOURCE_TYPE_SAMPLED_IMAGE, BindingKind::sampled_image);
    add(result, SPVC_RESOURCE_TYPE_STORAGE_IMAGE, BindingKind::storage_image);
    add(result, SPVC_RESOURCE_TYPE_SEPARATE_IMAGE, BindingKind::texel_buffer);
    for (const spvc_resource_type type :
         {SPVC_RESOURCE_TYPE_SEPARATE_SAMPLERS, SPVC_RESOURCE_TYPE_SUBPASS_INPUT,
          SPVC_RESOURCE_TYPE_ATOMIC_COUNTER})
      if (!list(type).empty())
        bad_shader(name_, fmt::format("'{}' is of a kind that is not supported", list(type)[0].name));
    std::ranges::sort(result.bindings, {}, &BindingSlot::binding);
    for (const spvc_reflected_resource& block : list(SPVC_RESOURCE_TYPE_PUSH_CONSTANT)) {
      std::size_t bytes = 0;
      need(spvc_compiler_get_declared_struct_size(
          compiler_, spvc_compiler_get_type_handle(compiler_, block.base_type_id), &bytes));
      result.push_bytes = static_cast<std::uint32_t>(bytes);
    }
    read_constants(result);
    if (spvc_compiler_get_execution_model(compiler_) == SpvExecutionModelGLCompute) read_workgroup(result);
    return result;
  }

 private:
  void need(spvc_result result) const {
    if (result != SPVC_SUCCESS)
      bad_shader(name_, context_ ? spvc_context_get_last_error_string(context_) : "out of memory");
  }

  std::span<const spvc_reflected_resource> list(spvc_resource_type type) const {
    const spvc_reflected_resource* first = nullptr;
    std::size_t count = 0;
    need(spvc_resources_get_resource_list_for_type(resources_, type, &first, &count));
    return {first, count};
  }

  void add(ShaderInterface& result, spvc_resource_type type, BindingKind kind) const {
    for (const spvc_reflected_resource& resource : list(type)) {
      const auto decoration = [&](SpvDecoration d) {
        return spvc_compiler_get_decoration(compiler_, resource.id, d);
      };
      // The name of a buffer block is that of its type; the name of the variable is more specific, if there
      // is one.
      const std::string variable = spvc_compiler_get_name(compiler_, resource.id);
      const std::string name = variable.empty() ? resource.name : variable;
      if (decoration(SpvDecorationDescriptorSet) != 0)
        bad_shader(name_, fmt::format("'{}' is not in descriptor set 0", name));
      spvc_type shape = spvc_compiler_get_type_handle(compiler_, resource.type_id);
      const unsigned dimensions = spvc_type_get_num_array_dimensions(shape);
      if (kind == BindingKind::texel_buffer && spvc_type_get_image_dimension(shape) != SpvDimBuffer)
        bad_shader(name_, fmt::format("'{}' is of a kind that is not supported", name));
      std::uint32_t count = 1;
      for (unsigned d = 0; d < dimensions; ++d) {
        if (!spvc_type_array_dimension_is_literal(shape, d))
          bad_shader(name_, fmt::format("'{}' is an array without a fixed size", name));
        count *= spvc_type_get_array_dimension(shape, d);
      }
      if (count == 0) bad_shader(name_, fmt::format("'{}' is an array without a size", name));
      result.bindings.push_back({decoration(SpvDecorationBinding), kind, count, name});
    }
  }

  void read_constants(ShaderInterface& result) const {
    const spvc_specialization_constant* constants = nullptr;
    std::size_t count = 0;
    need(spvc_compiler_get_specialization_constants(compiler_, &constants, &count));
    for (std::size_t i = 0; i < count; ++i) {
      const std::string name = spvc_compiler_get_name(compiler_, constants[i].id);
      // The size of a workgroup: glslc adds a constant without a name for each use of the declared one.
      if (name.empty()) continue;
      spvc_constant handle = spvc_compiler_get_constant_handle(compiler_, constants[i].id);
      spvc_type type = spvc_compiler_get_type_handle(compiler_, spvc_constant_get_type(handle));
      // A bool has the width 1 here, but 32 bits in the data for Vulkan.
      if (spvc_type_get_basetype(type) != SPVC_BASETYPE_BOOLEAN && spvc_type_get_bit_width(type) != 32)
        bad_shader(name_, fmt::format("specialisation constant '{}' is not of 32 bits", name));
      result.constants.emplace_back(name, constants[i].constant_id);
    }
    std::ranges::sort(result.constants, {}, &std::pair<std::string, std::uint32_t>::second);
  }

  void read_workgroup(ShaderInterface& result) const {
    std::array<spvc_specialization_constant, 3> by{};
    spvc_compiler_get_work_group_size_specialization_constants(compiler_, &by[0], &by[1], &by[2]);
    for (unsigned axis = 0; axis < 3; ++axis) {
      std::uint32_t size =
          spvc_compiler_get_execution_mode_argument_by_index(compiler_, SpvExecutionModeLocalSize, axis);
      if (by[axis].id != 0) {
        size = default_of(by[axis].id);
        result.workgroup_constants[axis] = by[axis].constant_id;
        check_default(by[axis].constant_id, size);
      }
      if (size == 0) bad_shader(name_, "has a workgroup without a size");
      result.workgroup[axis] = size;
    }
  }

  std::uint32_t default_of(spvc_constant_id id) const {
    return spvc_constant_get_scalar_u32(spvc_compiler_get_constant_handle(compiler_, id), 0, 0);
  }

  /// Checks that the default of a workgroup's size (local_size_x) equals that of the named constant with the
  /// same id; SPIR-V stores them separately.
  void check_default(std::uint32_t constant_id, std::uint32_t size) const {
    const spvc_specialization_constant* constants = nullptr;
    std::size_t count = 0;
    need(spvc_compiler_get_specialization_constants(compiler_, &constants, &count));
    for (std::size_t i = 0; i < count; ++i)
      if (constants[i].constant_id == constant_id && default_of(constants[i].id) != size)
        bad_shader(name_, fmt::format("local_size is {} but the constant that sets it, '{}', is {}", size,
                                      spvc_compiler_get_name(compiler_, constants[i].id),
                                      default_of(constants[i].id)));
  }

  const std::string& name_;
  spvc_context context_ = nullptr;
  spvc_compiler compiler_ = nullptr;
  spvc_resources resources_ = nullptr;
};

}  // namespace

VkDescriptorType descriptor_type(BindingKind kind) {
  switch (kind) {
    case BindingKind::storage_buffer: return VK_DESCRIPTOR_TYPE_STORAGE_BUFFER;
    case BindingKind::uniform_buffer: return VK_DESCRIPTOR_TYPE_UNIFORM_BUFFER;
    case BindingKind::texel_buffer: return VK_DESCRIPTOR_TYPE_UNIFORM_TEXEL_BUFFER;
    case BindingKind::sampled_image: return VK_DESCRIPTOR_TYPE_COMBINED_IMAGE_SAMPLER;
    case BindingKind::storage_image: return VK_DESCRIPTOR_TYPE_STORAGE_IMAGE;
  }
  return VK_DESCRIPTOR_TYPE_MAX_ENUM;
}

ShaderInterface reflect(std::span<const std::uint32_t> spirv, const std::string& name) {
  if (spirv.size() < 5 || spirv[0] != SpvMagicNumber) bad_shader(name, "is not SPIR-V");
  return Reflection(spirv, name).read();
}

}  // namespace dermis::gpu
