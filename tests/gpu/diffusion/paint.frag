// SPDX-License-Identifier: MIT
// Light that a test knows in closed form, in place of the irradiance pass.
#version 460
#include "render/shared/types.h"
#include "render/shaders/half.glsl"
#include "paint_io.h"
layout(push_constant, scalar) uniform Push { PaintIo io; };
layout(location = 0) in vec3 in_position_m;
layout(location = 1) flat in uint in_chart;
layout(location = 0) out vec4 out_light;

// Lit or not, seen at the texel's centre: what a hard shadow leaves in the map.
float lit(vec2 centre) { return dot(centre - io.edge_point, io.edge_normal) > 0.0 ? 1.0 : 0.0; }

// Legendre polynomials by their recurrence.
float legendre(uint band, float x) {
  float previous = 1.0, current = x;
  for (uint l = 1u; l < band; ++l) {
    const float next = ((2.0 * float(l) + 1.0) * x * current - float(l) * previous) / (float(l) + 1.0);
    previous = current;
    current = next;
  }
  return current;
}

void main() {
  const float value = io.band == 0u ? lit(gl_FragCoord.xy)
                                    : 1.0 + 0.5 * legendre(io.band, dot(io.axis, normalize(in_position_m)));
  out_light = vec4(round_to_half(vec3(value)), float(in_chart));
}
