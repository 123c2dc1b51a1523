// SPDX-License-Identifier: MIT
#version 460
#extension GL_GOOGLE_include_directive : require
#include "host.glsl"
layout(location = 0) in vec3 position_m;
layout(location = 1) in vec3 normal;
layout(location = 2) in vec2 uv;
layout(location = 0) out vec3 out_position_m;
layout(location = 1) out vec3 out_normal;
layout(location = 2) out vec2 out_uv;

void main() {
  const vec4 world_m = world_from_asset * vec4(position_m, 1.0);
  out_position_m = world_m.xyz;
  out_normal = mat3(world_from_asset) * normal;
  out_uv = uv;
  gl_Position = clip_from_world * world_m;
}
