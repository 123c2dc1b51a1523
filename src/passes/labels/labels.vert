// SPDX-License-Identifier: MIT
#version 460
#include "shared/scene_io.h"
#include "shaders/vertex_pull.glsl"
#include "shaders/placement.glsl"
#include "shaders/instance.glsl"
#include "shaders/frame.glsl"
layout(constant_id = 0) const bool skin = false;
layout(binding = 34, scalar) readonly buffer Parts { vec2 parts[]; };  // of the vertices of skin
layout(location = 0) out vec3 out_position_m;
layout(location = 1) out vec3 out_normal;
layout(location = 2) out vec4 out_uv;
layout(location = 3) out vec4 out_colour;
layout(location = 4) out vec2 out_part;
void main() {
  const VertexIo v = placed_vertex();
  out_position_m = world_position(v.position_m);
  out_normal = world_direction(v.normal);
  const VertexExtraIo extra = vertex_extra(gl_VertexIndex);
  out_uv = vec4(v.uv0, extra.uv1);
  out_colour = extra.colour;
  out_part = skin ? parts[gl_VertexIndex] : vec2(-1.0);
  gl_Position = frame.camera.clip_from_world * vec4(out_position_m, 1.0);
}
