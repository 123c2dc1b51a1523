// SPDX-License-Identifier: MIT
// Copies the indices of a triangle, or writes a triangle without area.
#version 460
#include "render/techniques/published/cull_io.h"
#include "render/shared/scene_io.h"
#include "render/shaders/vertex_pull.glsl"
#include "render/shaders/skin_vertex.glsl"
#include "render/shaders/head.glsl"
#include "render/shaders/frame.glsl"
layout(local_size_x = 64) in;
layout(push_constant, scalar) uniform Push { CullTrianglesIo io; };
layout(binding = 1, scalar) readonly buffer Indices { uint indices[]; };
layout(binding = 2, scalar) writeonly buffer Kept { uint kept[]; };
#include "render/techniques/published/cull.glsl"

void main() {
  if (gl_GlobalInvocationID.x >= io.count) return;
  const uint triangle = io.first + gl_GlobalInvocationID.x;
  const bool culled = io.cull.can_cull != 0u && triangle_culled(triangle, io.cull.side);
  for (uint k = 0u; k < 3u; ++k) kept[3u * triangle + k] = culled ? 0u : indices[3u * triangle + k];
}
