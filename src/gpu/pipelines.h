// SPDX-License-Identifier: MIT
// Pipelines from SPIR-V. Bindings, push-constant size, workgroup size and specialisation constants are read
// from the shader. Descriptor set 0, pushed at record time (VK_KHR_push_descriptor).
#pragma once

#include <array>
#include <cstdint>
#include <filesystem>
#include <functional>
#include <map>
#include <memory>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "gpu/resources.h"
#include "gpu/vulkan.h"

namespace dermis::gpu {

class Device;

enum class BindingKind : std::uint8_t {
  storage_buffer,
  uniform_buffer,
  texel_buffer,   ///< a buffer read as texels, see texel_format
  sampled_image,  ///< combined with a sampler
  storage_image
};

VkDescriptorType descriptor_type(BindingKind kind);

struct BindingSlot {
  std::uint32_t binding = 0;
  BindingKind kind{};
  std::uint32_t count = 1;
  std::string name;
};

/// The interface of one or two stages together, by reflection.
struct ShaderInterface {
  std::vector<BindingSlot> bindings;  ///< sorted by binding number
  std::uint32_t push_bytes = 0;
  std::array<std::uint32_t, 3> workgroup{1, 1, 1};  ///< in a Pipeline: with its constants applied
  static constexpr std::uint32_t fixed = 0xffffffff;
  /// constant_id that sets each size, or fixed
  std::array<std::uint32_t, 3> workgroup_constants{fixed, fixed, fixed};
  /// specialisation constants: name, constant_id
  std::vector<std::pair<std::string, std::uint32_t>> constants;
};
ShaderInterface reflect(std::span<const std::uint32_t> spirv, const std::string& name);

/// Named specialisation constants, bool and int as 32 bits. A name that the shader does not declare is our
/// bug (assertion).
using Constants = std::vector<std::pair<std::string, std::uint32_t>>;

enum class Blend : std::uint8_t { none, over };  ///< over: premultiplied alpha
enum class Cull : std::uint8_t { none, back, front };

struct GraphicsDesc {
  std::string vertex;    ///< shader names; vertices are read from storage buffers
  std::string fragment;  ///< empty: depth only
  Constants constants;   ///< for both stages; each takes those that it declares
  std::vector<VkFormat> colour_formats;
  VkFormat depth_format = VK_FORMAT_UNDEFINED;
  std::uint32_t samples = 1;
  Blend blend = Blend::none;
  Cull cull = Cull::none;  ///< front = counter-clockwise (viewport with negative height, as glTF)
  bool depth_test = false, depth_write = false;
  VkCompareOp depth_compare = VK_COMPARE_OP_GREATER_OR_EQUAL;  ///< reversed Z
  bool depth_clamp = false;
  float depth_bias = 0, depth_bias_slope = 0;
  bool alpha_to_coverage = false;
};

class Pipeline {
 public:
  VkPipeline handle = VK_NULL_HANDLE;
  VkPipelineLayout layout = VK_NULL_HANDLE;
  VkPipelineBindPoint bind_point = VK_PIPELINE_BIND_POINT_COMPUTE;
  VkShaderStageFlags push_stages = 0;
  VkCullModeFlags cull_mode = VK_CULL_MODE_NONE;  ///< set when it is bound
  ShaderInterface interface;
  std::string name;
};

/// Returns SPIR-V by name ("blur.comp"); an empty span if there is none.
using ShaderSource = std::function<std::span<const std::uint32_t>(std::string_view name)>;

/// Makes each pipeline once and keeps it. With a cache file, driver code is kept between runs. save_cache()
/// replaces a file that is missing, damaged or from another driver (atomically); if it cannot be written, it
/// warns and does not try again.
class PipelineLibrary {
 public:
  PipelineLibrary(Device& device, ShaderSource shaders, std::filesystem::path cache_file = {});
  /// Keeps driver code in a host's cache, which it does not own, if that is not null. `replaced`: shaders in
  /// place of those of `shaders`; may be empty. Making a pipeline throws InputError if the interface of one
  /// differs.
  PipelineLibrary(Device& device, ShaderSource shaders, std::filesystem::path cache_file,
                  VkPipelineCache of_host, ShaderSource replaced);
  PipelineLibrary(const PipelineLibrary&) = delete;
  PipelineLibrary& operator=(const PipelineLibrary&) = delete;
  ~PipelineLibrary();

  /// References are valid as long as the library.
  const Pipeline& compute(const std::string& shader, const Constants& constants = {});
  const Pipeline& graphics(const GraphicsDesc& desc);
  VkSampler sampler(const SamplerDesc& desc);
  void save_cache() const;
  double creation_ms() const;  ///< time spent on pipelines so far
  Device& device();

 private:
  struct State;
  std::unique_ptr<State> state_;
};

/// Returns $XDG_CACHE_HOME/dermis/pipelines.bin or ~/.cache/dermis/pipelines.bin; empty if neither variable
/// is set.
std::filesystem::path default_pipeline_cache();

}  // namespace dermis::gpu
