// SPDX-License-Identifier: MIT
// Marks the tiles that a triangle touches: with its material, and as seen if a pixel may show it. By the
// triangle's bounds on the map, so that one without a texel of its own is found, too.
#version 460
#include "render/passes/light_map/tiles/tiles_io.h"
#include "render/shared/scene_io.h"
#include "render/shaders/tile_list.glsl"
#include "render/shaders/vertex_pull.glsl"
#include "render/shaders/skin_vertex.glsl"
#include "render/shaders/head.glsl"
#include "render/shaders/frame.glsl"
layout(local_size_x = 64) in;
layout(push_constant, scalar) uniform Push { SeenTilesIo io; };
layout(binding = 1, scalar) readonly buffer Indices { uint indices[]; };
layout(binding = 2, scalar) buffer TileMarks { uint tile_marks[]; };
#include "render/shaders/cull.glsl"

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
  const bool unseen =
      (cull && io.can_cull != 0u && triangle_culled(triangle)) || (clip && is_outside(triangle));
  const uint marks = tile_material(io.list) | (unseen ? 0u : uint(TILE_SEEN));

  const vec2 a = unwrap_of(indices[3u * triangle]), b = unwrap_of(indices[3u * triangle + 1u]),
             c = unwrap_of(indices[3u * triangle + 2u]);
  const float side = float(io.side);
  const uvec2 low = uvec2(clamp(min(a, min(b, c)) * side - io.reach, 0.0, side - 1.0)),
              high = uvec2(clamp(max(a, max(b, c)) * side + io.reach, 0.0, side - 1.0));
  for (uint y = low.y / TILE_SIDE; y <= high.y / TILE_SIDE; ++y)
    for (uint x = low.x / TILE_SIDE; x <= high.x / TILE_SIDE; ++x)
      atomicOr(tile_marks[io.first_tile + y * tiles_across(io.side).x + x], marks);
}
