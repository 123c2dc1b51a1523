// SPDX-License-Identifier: MIT
// Which triangle each texel of the light maps shows: what TexelMap draws, and compute passes in texture space
// read.
#pragma once

#include "frame/graph.h"

namespace dermis::passes {

struct TexelMaps {
  /// R32_UINT pool, persistent: number of the triangle in GpuMesh::indices, plus one; 0: none
  frame::TextureId numbers;
  frame::BufferId stamps;  ///< uint[], one per square, persistent: the unwrap and the side T that it holds
  frame::BufferId draws;   ///< VkDrawIndirectCommand[], one per square
  bool valid() const { return numbers.valid(); }
};

/// Makes the maps of a pool. `light`: a texture of it that is not halved.
TexelMaps make_texel_maps(frame::FrameGraph& graph, const gpu::TextureDesc& light, std::uint32_t squares);

}  // namespace dermis::passes
