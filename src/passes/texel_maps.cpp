// SPDX-License-Identifier: MIT
#include "passes/texel_maps.h"

namespace dermis::passes {

TexelMaps make_texel_maps(frame::FrameGraph& graph, const gpu::TextureDesc& light, std::uint32_t squares) {
  gpu::TextureDesc numbers = light;
  numbers.format = VK_FORMAT_R32_UINT;
  return {.numbers = graph.texture("texel map", numbers, frame::Lifetime::persistent),
          .stamps = graph.buffer("texel map stamps", {.bytes = squares * sizeof(std::uint32_t)},
                                 frame::Lifetime::persistent),
          .draws = graph.buffer("texel map draws", {.bytes = squares * sizeof(VkDrawIndirectCommand)})};
}

}  // namespace dermis::passes
