// SPDX-License-Identifier: MIT
// One texel of the head's light, drawn. GROUPS: as lit_texel.glsl.
#include "shared/scene_io.h"
#include "passes/irradiance/lit_texel.glsl"

layout(location = 0) in vec3 in_position_m;
layout(location = 1) in vec3 in_normal;
layout(location = 2) in vec4 in_tangent;
layout(location = 3) in vec4 in_uv;
layout(location = 4) in vec4 in_colour;
layout(location = 5) flat in uint in_chart;
layout(location = 6) in vec2 in_unwrap;
layout(location = 7) in float in_plane_m;  // plane_distance()

layout(location = 0) out vec4 out_light;
#if GROUPS > 1
layout(location = 1) out vec4 out_second;
#endif
#if GROUPS > 2
layout(location = 2) out vec4 out_third;
#endif

void main() {
  const ShadingPoint s = drawn_point(in_position_m, in_normal, in_plane_m, in_tangent, in_uv, in_colour, 1.0);
  const LitTexel lit = lit_texel(s, in_unwrap, float(in_chart), cut_texel(in_uv, in_colour));
  if (cut_out && lit.group[0].a == 0.0) discard;

  out_light = lit.group[0];
#if GROUPS > 1
  out_second = lit.group[1];
#endif
#if GROUPS > 2
  out_third = lit.group[2];
#endif
}
