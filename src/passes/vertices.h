// SPDX-License-Identifier: MIT
// Vertices of the scene as shaders read them.
#pragma once

#include "scene/scene.h"
#include "shared/scene_io.h"

namespace dermis::passes {

/// Returns a vertex of parts that are not skin; skin adds its unwrap and metric.
inline io::VertexIo vertex_io(const scene::Vertex& v) {
  return {.position_m = v.position_m,
          .normal = v.normal,
          .tangent = v.tangent,
          .uv0 = v.uv0,
          .uv1 = v.uv1,
          .colour = v.colour,
          .unwrap = {},
          .metric_mm2 = {}};
}

}  // namespace dermis::passes
