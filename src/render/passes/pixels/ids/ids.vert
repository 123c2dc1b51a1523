// SPDX-License-Identifier: MIT
#version 460
#include "render/passes/pixels/ids/ids_io.h"
#include "render/shared/scene_io.h"
#include "render/shaders/vertex_pull.glsl"
#include "render/shaders/first_corner.glsl"
#include "render/shaders/head.glsl"
#include "render/shaders/frame.glsl"
layout(push_constant, scalar) uniform Push { IdsIo io; };
layout(location = 0) flat out uint out_id;
layout(location = 3) out vec4 out_uv;
layout(location = 4) out vec4 out_colour;
void main() {
  const uint vertex = vertex_drawn();
  const VertexIo v = vertex_at(vertex);
  const VertexExtraIo extra = vertex_extra(vertex);
  out_id = io.first_id + uint(gl_VertexIndex);
  out_uv = vec4(v.uv0, extra.uv1);
  out_colour = extra.colour;
  gl_Position = clip_position(world_position(v.position_m));
}
