// SPDX-License-Identifier: MIT
// Lists of the texels that a frame lights: what ListTexels writes, and passes over lit texels read; see
// shared/texel_lists_io.h.
#pragma once

#include "frame/graph.h"
#include "passes/light_pool.h"

namespace dermis::passes {

struct TexelLists {
  /// R32_UINT pool: entry i of a square with T texels per side is the texel (i mod T, i / T) of the square,
  /// and holds the place of a texel in it, x | y << 16.
  frame::TextureId entries;
  frame::BufferId lists;        ///< TexelListIo[], `materials` per square
  frame::BufferId arguments;    ///< TexelArgumentsIo[], likewise
  std::uint32_t materials = 1;  ///< of the skin mesh with most
  bool valid() const { return entries.valid(); }
};

/// Makes the lists of a pool. `light`: a texture of it that is not halved.
TexelLists make_texel_lists(frame::FrameGraph& graph, const gpu::TextureDesc& light, std::uint32_t squares,
                            std::uint32_t materials);

/// Returns the number of the list of a square's n-th material.
inline std::uint32_t texel_list(const TexelLists& lists, const UsedSquare& square, std::size_t material) {
  return square.index * lists.materials + static_cast<std::uint32_t>(material);
}

}  // namespace dermis::passes
