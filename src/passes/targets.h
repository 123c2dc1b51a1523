// SPDX-License-Identifier: MIT
// What passes draw into.
#pragma once

#include <array>
#include <span>

#include "gpu/cmd.h"
#include "gpu/vulkan.h"

namespace dermis::passes {

inline constexpr VkFormat light_format = VK_FORMAT_R16G16B16A16_SFLOAT;  ///< linear light, and maps of skin
inline constexpr VkFormat depth_format = VK_FORMAT_D32_SFLOAT;           ///< reversed: 0 is far
inline constexpr std::array no_light{0.0f, 0.0f, 0.0f, 0.0f};

/// Begins to draw into the whole picture. The first pass to do so clears it.
inline void begin_picture(gpu::Cmd& cmd, const gpu::Texture& colour, const gpu::Texture& depth, bool clear) {
  gpu::ColourTarget colour_target{.texture = &colour};
  gpu::DepthTarget depth_target{.texture = &depth};
  if (clear) {
    colour_target.clear = no_light;
    depth_target.clear = 0.0f;
  }
  cmd.begin_rendering(std::span(&colour_target, 1), depth_target,
                      {colour.desc().width, colour.desc().height});
}

}  // namespace dermis::passes
