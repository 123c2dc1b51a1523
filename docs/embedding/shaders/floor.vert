// SPDX-License-Identifier: MIT
#version 460
#extension GL_GOOGLE_include_directive : require
#include "host.glsl"
layout(location = 0) out vec2 at_m;

// Two triangles, from -2 m to 2 m, seen from above.
void main() {
  const vec2 corners[6] =
      vec2[](vec2(-2, -2), vec2(-2, 2), vec2(2, -2), vec2(2, -2), vec2(-2, 2), vec2(2, 2));
  at_m = corners[gl_VertexIndex];
  gl_Position = clip_from_world * world_from_asset * vec4(at_m.x, 0.0, at_m.y, 1.0);
}
