// SPDX-License-Identifier: MIT
#version 460
#include "render/shared/scene_io.h"
#include "render/shaders/vertex_pull.glsl"
#include "render/shaders/skin_vertex.glsl"
#include "render/shaders/first_corner.glsl"
#include "render/shaders/head.glsl"
#include "render/shaders/frame.glsl"
#include "render/techniques/published/cull.glsl"
#include "render/techniques/published/cull_io.h"
layout(push_constant, scalar) uniform Push { CullIo io; };
layout(location = 0) out vec3 out_position_m;
layout(location = 1) flat out uint out_culled;
layout(location = 2) out vec4 out_uv;
layout(location = 3) out vec4 out_colour;

void main() {
  const uint vertex = vertex_drawn();
  const VertexIo v = vertex_at(vertex);
  const VertexExtraIo extra = vertex_extra(vertex);
  out_position_m = world_position(v.position_m);
  out_uv = vec4(v.uv0, extra.uv1);
  out_colour = extra.colour;
  out_culled = io.can_cull != 0u && is_first_corner() && triangle_culled(gl_VertexIndex, io.side) ? 1u : 0u;
  gl_Position = vec4(unwrap_of(vertex) * 2.0 - 1.0, 0.5, 1.0);
}
