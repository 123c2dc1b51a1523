// SPDX-License-Identifier: MIT
// Vertices of the scene as shaders read them.
#pragma once

#include <cstring>
#include <vector>

#include "head/scene/asset_data.h"
#include "render/shared/scene_io.h"

namespace dermis::passes {

inline io::VertexIo vertex_io(const scene::Vertex& v) {
  return {.position_m = v.position_m, .normal = v.normal, .tangent = v.tangent, .uv0 = v.uv0};
}

inline io::VertexExtraIo vertex_extra_io(const scene::Vertex& v) {
  return {.colour = v.colour, .uv1 = v.uv1, .unused = {}};
}

/// Leaves only the first if all are equal to the bit.
inline void join_equal(std::vector<io::VertexExtraIo>& extras) {
  for (const io::VertexExtraIo& extra : extras)
    if (std::memcmp(&extra, extras.data(), sizeof(extra)) != 0) return;
  if (!extras.empty()) extras.erase(extras.begin() + 1, extras.end());
}

}  // namespace dermis::passes
