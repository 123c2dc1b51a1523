// SPDX-License-Identifier: MIT
// The triangles of heads that light maps hold: what CullTriangles writes, and passes in texture space draw.
#pragma once

#include "frame/graph.h"
#include "frame/resources.h"
#include "gpu/cmd.h"
#include "passes/light_pool.h"

namespace dermis::passes {

/// A part for each square of a pool, with indices as GpuMesh::indices.
struct KeptTriangles {
  frame::BufferId indices;         ///< uint[]; not valid: nothing is culled
  std::uint64_t square_bytes = 0;  ///< of a part
  bool valid() const { return indices.valid(); }
};

/// Makes the buffer for meshes of at most `triangles` triangles.
KeptTriangles make_kept_triangles(frame::FrameGraph& graph, std::uint32_t squares, std::uint32_t triangles);

inline gpu::BufferBinding kept_in(const KeptTriangles& kept, const frame::Resources& resources,
                                  const UsedSquare& square) {
  return {&resources.buffer(kept.indices), square.index * kept.square_bytes, kept.square_bytes};
}

}  // namespace dermis::passes
