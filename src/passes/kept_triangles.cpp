// SPDX-License-Identifier: MIT
#include "passes/kept_triangles.h"

#include <algorithm>

namespace dermis::passes {

KeptTriangles make_kept_triangles(frame::FrameGraph& graph, std::uint32_t squares, std::uint32_t triangles) {
  // Parts are bound as storage: their offsets are multiples of the largest alignment that Vulkan allows.
  constexpr std::uint64_t alignment = 256;
  const std::uint64_t bytes = std::max<std::uint64_t>(triangles, 1) * 3 * sizeof(std::uint32_t);
  KeptTriangles kept{.indices = {}, .square_bytes = (bytes + alignment - 1) / alignment * alignment};
  kept.indices = graph.buffer("kept triangles", {.bytes = squares * kept.square_bytes});
  return kept;
}

}  // namespace dermis::passes
