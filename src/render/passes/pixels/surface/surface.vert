// SPDX-License-Identifier: MIT
#version 460
#include "render/shared/scene_io.h"
#include "render/shaders/vertex_pull.glsl"
#include "render/shaders/placement.glsl"
#include "render/shaders/head.glsl"
#include "render/shaders/frame.glsl"
#include "render/shaders/bulge.glsl"
invariant gl_Position;  // host_depth.vert has the same
layout(location = 0) out vec3 out_position_m;
layout(location = 1) out vec3 out_normal;
layout(location = 2) out vec4 out_tangent;
layout(location = 3) out vec4 out_uv;
layout(location = 4) out vec4 out_colour;
layout(location = 5) out float out_plane_m;
void main() {
  const VertexIo v = placed_vertex();
  out_position_m = world_position(v.position_m);
  out_normal = world_direction(v.normal);
  out_plane_m = plane_distance(out_position_m, out_normal);
  out_tangent = vec4(world_direction(v.tangent.xyz), v.tangent.w);
  const VertexExtraIo extra = vertex_extra(gl_VertexIndex);
  out_uv = vec4(v.uv0, extra.uv1);
  out_colour = extra.colour;
  gl_Position = clip_position(out_position_m);
}
