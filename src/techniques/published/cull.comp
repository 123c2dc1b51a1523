// SPDX-License-Identifier: MIT
// Copies the indices of a triangle, or writes a triangle without area.
#version 460
#include "techniques/published/cull_io.h"
#include "shared/scene_io.h"
#include "shaders/vertex_pull.glsl"
#include "shaders/skin_vertex.glsl"
#include "shaders/instance.glsl"
#include "shaders/frame.glsl"
layout(local_size_x = 64) in;
layout(push_constant, scalar) uniform Push { CullTrianglesIo io; };
layout(binding = 1, scalar) readonly buffer Indices { uint indices[]; };
layout(binding = 2, scalar) writeonly buffer Kept { uint kept[]; };
#include "techniques/published/cull.glsl"

void main() {
  if (gl_GlobalInvocationID.x >= io.count) return;
  const uint triangle = io.first + gl_GlobalInvocationID.x;
  const bool culled = io.cull.can_cull != 0u && triangle_culled(triangle, io.cull.map_side);
  for (uint k = 0u; k < 3u; ++k) kept[3u * triangle + k] = culled ? 0u : indices[3u * triangle + k];
}
