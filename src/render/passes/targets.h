// SPDX-License-Identifier: MIT
// Targets of passes.
#pragma once

#include <array>
#include <optional>
#include <span>

#include "gpu/cmd.h"
#include "gpu/vulkan.h"

namespace dermis::passes {

inline constexpr VkFormat light_format = VK_FORMAT_R16G16B16A16_SFLOAT;  ///< linear light, and maps of skin
inline constexpr VkFormat depth_format = VK_FORMAT_D32_SFLOAT;           ///< reversed: 0 is far
inline constexpr std::array no_light{0.0f, 0.0f, 0.0f, 0.0f};

/// Targets of a picture: dermis's own, or a host's.
struct PictureFormat {
  VkFormat colour = light_format, depth = depth_format;
  bool reversed_depth = true;
  VkCompareOp nearer() const {
    return reversed_depth ? VK_COMPARE_OP_GREATER_OR_EQUAL : VK_COMPARE_OP_LESS_OR_EQUAL;
  }
  bool operator==(const PictureFormat&) const = default;
};

/// Begins to draw into the picture, or this part of it. The first pass to do so clears it.
inline void begin_picture(gpu::Cmd& cmd, const gpu::Texture& colour, const gpu::Texture& depth, bool clear,
                          const std::optional<VkRect2D>& area) {
  gpu::ColourTarget colour_target{.texture = &colour};
  gpu::DepthTarget depth_target{.texture = &depth};
  if (clear) {
    colour_target.clear = no_light;
    depth_target.clear = 0.0f;
  }
  const VkRect2D whole{{0, 0}, {colour.desc().width, colour.desc().height}};
  cmd.begin_rendering_area(std::span(&colour_target, 1), depth_target, area.value_or(whole));
}

/// Begins to draw over skin that is in `depth` already. Alpha is what the layer hides.
inline void begin_layer(gpu::Cmd& cmd, const gpu::Texture& colour, const gpu::Texture& depth, bool clear) {
  gpu::ColourTarget target{.texture = &colour};
  if (clear) target.clear = no_light;
  cmd.begin_rendering(std::span(&target, 1), gpu::DepthTarget{.texture = &depth},
                      {colour.desc().width, colour.desc().height});
}

}  // namespace dermis::passes
