// SPDX-License-Identifier: MIT
#include "passes/texel_lists.h"

#include "shared/texel_lists_io.h"

namespace dermis::passes {

TexelLists make_texel_lists(frame::FrameGraph& graph, const gpu::TextureDesc& light, std::uint32_t squares,
                            std::uint32_t materials) {
  gpu::TextureDesc entries = light;
  entries.format = VK_FORMAT_R32_UINT;
  const std::uint64_t lists = std::uint64_t{squares} * materials;
  return {.entries = graph.texture("lit texels", entries),
          .lists = graph.buffer("texel lists", {.bytes = lists * sizeof(io::TexelListIo)}),
          .arguments = graph.buffer("texel arguments", {.bytes = lists * sizeof(io::TexelArgumentsIo)}),
          .materials = materials};
}

}  // namespace dermis::passes
