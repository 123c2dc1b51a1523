// SPDX-License-Identifier: MIT
#version 460
#extension GL_GOOGLE_include_directive : require
#include "host.glsl"
layout(location = 0) in vec2 at_m;
layout(location = 0) out vec4 colour;

// A matt board, whose edges fade into the dark.
void main() {
  const ivec2 cell = ivec2(floor(at_m / 0.08));
  const float shade = ((cell.x + cell.y) & 1) == 0 ? 1.0 : 0.6;
  const float fade = exp(-2.0 * dot(at_m, at_m));
  colour = vec4(albedo.rgb * shade * fade * lamp_irradiance.rgb * (to_lamp.y / pi), 0.0);
}
