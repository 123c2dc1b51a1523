// SPDX-License-Identifier: MIT
#version 460
#include "render/shared/scene_io.h"
#include "render/shaders/vertex_pull.glsl"
#include "render/shaders/placement.glsl"
#include "render/shaders/head.glsl"
#include "render/passes/shadow/shadow_io.h"
// Geometry enlarged by a texel covers every texel that it touches, so that maps smaller than the depth map
// miss no thin rim.
layout(constant_id = 3) const bool grown = false;
layout(push_constant, scalar) uniform Push { ShadowIo io; };
layout(location = 0) out vec2 out_uv0;
layout(location = 1) out vec2 out_uv1;
layout(location = 2) out vec4 out_colour;
void main() {
  const VertexIo v = vertex_at(gl_VertexIndex);
  const VertexExtraIo extra = vertex_extra(gl_VertexIndex);
  out_uv0 = v.uv0;
  out_uv1 = extra.uv1;
  out_colour = extra.colour;
  const vec3 in_asset_m = placed_position(placements[gl_InstanceIndex], v.position_m);
  gl_Position = io.shadow_from_world * vec4(world_position(in_asset_m), 1.0);
  if (grown) {
    const mat4 m = io.shadow_from_world;
    const float texel_m = io.grow * abs(gl_Position.w) / length(vec3(m[0][0], m[1][0], m[2][0]));
    gl_Position += m * vec4(texel_m * world_direction(placed_vertex().normal), 0.0);
  }
}
