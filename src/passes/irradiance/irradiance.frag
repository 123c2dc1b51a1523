// SPDX-License-Identifier: MIT
// One texel of the head's light: E albedo^mix / pi 2^EV, the input of the convolution. Alpha is the number of
// the chart, 0 where nothing was shaded.
#version 460
#include "shared/scene_io.h"
#include "shaders/half.glsl"
#include "shaders/skin_point.glsl"
#include "shaders/skin_lights.glsl"
#include "passes/irradiance/cut_chart.glsl"
layout(location = 0) in vec3 in_position_m;
layout(location = 1) in vec3 in_normal;
layout(location = 2) in vec4 in_tangent;
layout(location = 3) in vec4 in_uv;
layout(location = 4) in vec4 in_colour;
layout(location = 5) flat in uint in_chart;
layout(location = 6) in vec2 in_unwrap;
layout(location = 0) out vec4 out_light;
void main() {
  const vec3 n_geometric = normalize(in_normal);
  const ShadingPoint s = ShadingPoint(in_position_m, n_geometric, in_tangent, in_uv.xy, in_uv.zw, in_colour);
  const vec3 n = mapped_normal(material.maps[MAP_NORMAL], map_normal, s);
  const vec3 e = lit_skin(s, n, n_geometric, skin_specular(s), true, unseen).entering +
                 entering_surroundings(s, n, in_unwrap);
  const float chart = cut_out ? chart_left(float(in_chart), in_uv, in_colour) : float(in_chart);
  vec3 albedo = skin_albedo(s);
  if (cut_out && chart == BORDER_ALPHA) albedo = albedo_beside(in_uv, in_colour);
  const vec3 before = albedo_power(albedo, material.mix_before);
  if (cut_out && chart == 0.0) discard;
  out_light = vec4(storable(e * before * (frame.radiance_scale / pi)), chart);
}
