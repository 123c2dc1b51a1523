// SPDX-License-Identifier: MIT
// Copies the indices of a triangle, or writes a triangle without area.
#version 460
#include "passes/cull_triangles/cull_triangles_io.h"
#include "shared/scene_io.h"
#include "shaders/vertex_pull.glsl"
#include "shaders/skin_vertex.glsl"
#include "shaders/instance.glsl"
#include "shaders/frame.glsl"
layout(local_size_x = 64) in;
layout(push_constant, scalar) uniform Push { CullTrianglesIo io; };
layout(binding = 1, scalar) readonly buffer Indices { uint indices[]; };
layout(binding = 2, scalar) writeonly buffer Kept { uint kept[]; };
#include "shaders/cull.glsl"

layout(constant_id = 0) const bool cull = true;
layout(constant_id = 1) const bool clip = false;

// Returns whether all of a triangle lies outside one plane of the picture and its margin.
bool is_outside(uint triangle) {
  bvec4 outside = bvec4(true);
  bool beyond = true;
  for (uint i = 0u; i < 3u; ++i) {
    const vec3 p = world_position(vertex_position(indices[3u * triangle + i]));
    for (int plane = 0; plane < 4; ++plane)
      outside[plane] = outside[plane] && distance_inside(plane, p) < 0.0;
    beyond = beyond && distance_inside(4, p) < 0.0;
  }
  return beyond || any(outside);
}

void main() {
  if (gl_GlobalInvocationID.x >= io.count) return;
  const uint triangle = io.first + gl_GlobalInvocationID.x;
  const bool culled = (cull && io.cull.can_cull != 0u && triangle_culled(triangle, io.cull.map_side)) ||
                      (clip && is_outside(triangle));
  for (uint k = 0u; k < 3u; ++k) kept[3u * triangle + k] = culled ? 0u : indices[3u * triangle + k];
}
