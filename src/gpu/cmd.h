// SPDX-License-Identifier: MIT
// A thin recorder over a VkCommandBuffer, ours or an engine's. It creates nothing and submits nothing.
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <variant>
#include <vector>

#include "dermis/recorded_work.h"
#include "gpu/pipelines.h"
#include "gpu/resources.h"
#include "gpu/vulkan.h"

namespace dermis::gpu {

/// One resource for one binding, in the order of the shader's binding numbers.
struct SampledBinding {
  const Texture* texture = nullptr;
  VkSampler sampler = VK_NULL_HANDLE;
  VkImageLayout layout = VK_IMAGE_LAYOUT_SHADER_READ_ONLY_OPTIMAL;
};
struct StorageImageBinding {
  const Texture* texture = nullptr;
};
struct BufferBinding {
  const Buffer* buffer = nullptr;
  std::uint64_t offset = 0;
  std::uint64_t bytes = VK_WHOLE_SIZE;
};
using Binding = std::variant<SampledBinding, StorageImageBinding, BufferBinding>;

/// Invocations in x that every device takes in one dispatch, in workgroups of 64.
inline constexpr std::uint32_t most_in_row = 65535 * 64;

/// Required layouts of targets (and of what they resolve to) when rendering begins.
inline constexpr VkImageLayout colour_target_layout = VK_IMAGE_LAYOUT_COLOR_ATTACHMENT_OPTIMAL;
inline constexpr VkImageLayout depth_target_layout = VK_IMAGE_LAYOUT_DEPTH_ATTACHMENT_OPTIMAL;

struct ColourTarget {
  const Texture* texture = nullptr;
  std::uint32_t layer = 0;
  std::optional<std::array<float, 4>> clear = std::nullopt;  ///< none: load
  const Texture* resolve = nullptr;                          ///< mean of the samples, written at the end
};
struct DepthTarget {
  const Texture* texture = nullptr;
  std::uint32_t layer = 0;
  std::optional<float> clear = std::nullopt;  ///< none: load
  bool store = true;
};

class Cmd {
 public:
  enum class Work : std::uint8_t { none, compute, rendering };

  /// `before`: the last work of the frame so far, so that RecordedWork::switches is that of a frame.
  Cmd(Device& device, VkCommandBuffer handle, Work before = Work::none);
  VkCommandBuffer handle() const { return handle_; }
  Device& device() const { return *device_; }

  /// Binds resources; asserts number and kind against reflection.
  void bind(const Pipeline& pipeline, std::span<const Binding> bindings);
  template <class Push>
  void push(const Pipeline& pipeline, const Push& values) {
    push_bytes(pipeline, std::as_bytes(std::span(&values, 1)));
  }
  /// Pushes constants; asserts the size against reflection.
  void push_bytes(const Pipeline& pipeline, std::span<const std::byte> values);
  void dispatch(std::uint32_t groups_x, std::uint32_t groups_y, std::uint32_t groups_z = 1);
  void dispatch_over(const Pipeline& pipeline, std::uint32_t threads_x, std::uint32_t threads_y,
                     std::uint32_t threads_z = 1);  ///< rounds up to workgroups
  void dispatch_indirect(const Buffer& arguments, std::uint64_t offset);

  /// Begins rendering with a viewport over the full target, +Y up (negative height) unless y_down;
  /// set_viewport changes it.
  void begin_rendering(std::span<const ColourTarget> colour, const std::optional<DepthTarget>& depth,
                       VkExtent2D extent, bool y_down = false) {
    begin_rendering_area(colour, depth, {{0, 0}, extent}, y_down);
  }
  /// Clears, loads and draws only this part of the targets; the viewport is the area.
  void begin_rendering_area(std::span<const ColourTarget> colour, const std::optional<DepthTarget>& depth,
                            VkRect2D area, bool y_down = false);
  void set_viewport(VkRect2D area, bool y_down);  ///< viewport and scissor
  void set_scissor(VkRect2D area);
  void end_rendering();
  void draw(std::uint32_t vertices, std::uint32_t instances = 1, std::uint32_t first_vertex = 0,
            std::uint32_t first_instance = 0);
  /// 32-bit indices; `first` counts from the offset of the binding, bytes.
  void draw_indexed(const BufferBinding& indices, std::uint32_t count, std::uint32_t first = 0,
                    std::uint32_t instances = 1, std::uint32_t first_instance = 0);

  void copy(const Buffer& from, const Buffer& to, std::uint64_t bytes);
  /// Copies mip 0, tightly packed; `from` must be in TRANSFER_SRC layout.
  void copy(const Texture& from, const Buffer& to, std::uint32_t layer = 0);
  void fill(const Buffer& to, std::uint32_t value);
  /// Writes bytes that travel in the command buffer itself: a multiple of 4, few of them.
  void update(const Buffer& to, std::span<const std::byte> bytes);
  void barrier(const VkDependencyInfo& dependencies);
  /// Makes all that was written before visible to all that comes after.
  void barrier_all();
  const RecordedWork& recorded() const { return recorded_; }  ///< so far
  Work last() const { return last_; }

 private:
  void goes_on_with(Work work);

  Device* device_;
  VkCommandBuffer handle_;
  RecordedWork recorded_;
  Work last_;
};

}  // namespace dermis::gpu
