// SPDX-License-Identifier: MIT
#version 460
#include "render/passes/pixels/host_depth/host_depth_io.h"
#include "render/shared/scene_io.h"
#include "render/shaders/vertex_pull.glsl"
#include "render/shaders/placement.glsl"
layout(push_constant, scalar) uniform Push { HostDepthIo io; };
#define WORLD_FROM_ASSET io.world_from_asset
#include "render/shaders/head.glsl"
#include "render/shaders/clip.glsl"
invariant gl_Position;  // equal to that of the picture
layout(location = 0) out vec2 out_uv0;
layout(location = 1) out vec2 out_uv1;
layout(location = 2) out vec4 out_colour;
void main() {
  const VertexIo v = vertex_at(gl_VertexIndex);
  const VertexExtraIo extra = vertex_extra(gl_VertexIndex);
  out_uv0 = v.uv0;
  out_uv1 = extra.uv1;
  out_colour = extra.colour;
  const vec3 position_m = world_position(placed_position(placements[gl_InstanceIndex], v.position_m));
  gl_Position = clip_position(io.clip_from_world, position_m);
}
