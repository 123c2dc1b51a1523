// SPDX-License-Identifier: MIT
// One texel of the head's light, as irradiance.frag, from irradiance that a host has drawn there. Alpha 0:
// it has not.
#version 460
#include "shared/scene_io.h"
#include "shaders/half.glsl"
#include "shaders/skin_point.glsl"
#include "shaders/cut_chart.glsl"
layout(binding = 24) uniform sampler2D host_irradiance;
layout(location = 0) in vec3 in_position_m;
layout(location = 1) in vec3 in_normal;
layout(location = 2) in vec4 in_tangent;
layout(location = 3) in vec4 in_uv;
layout(location = 4) in vec4 in_colour;
layout(location = 5) flat in uint in_chart;
layout(location = 6) in vec2 in_unwrap;
layout(location = 0) out vec4 out_light;
void main() {
  // No shadow is looked up, so the bulge is not asked for.
  const ShadingPoint s = ShadingPoint(in_position_m, in_position_m, normalize(in_normal), 0.0, in_tangent,
                                      in_uv.xy, in_uv.zw, in_colour);
  const vec4 e = texelFetch(host_irradiance, ivec2(gl_FragCoord.xy), 0);
  const CutTexel cut = cut_texel(in_uv, in_colour);
  const float chart = cut_out ? chart_left(float(in_chart), cut) : float(in_chart);
  vec3 albedo = skin_albedo(s);
  if (cut_out && chart == BORDER_ALPHA) albedo = albedo_beside(cut);
  const vec3 before = albedo_power(albedo, material.mix_before);
  if (e.a == 0.0 || (cut_out && chart == 0.0)) discard;
  out_light = vec4(storable(e.rgb * before * (frame.radiance_scale / pi)), chart);
}
