// SPDX-License-Identifier: MIT
// One texel of the head's light, as irradiance.frag, with transmitted light. GROUPS: of the profile's terms,
// each with a target; see passes/transmission.h.
#include "shared/scene_io.h"
#include "shaders/half.glsl"
#include "shaders/skin_point.glsl"
#include "shaders/skin_lights.glsl"
#include "shaders/skin_through.glsl"
#include "passes/irradiance/cut_chart.glsl"
layout(location = 0) in vec3 in_position_m;
layout(location = 1) in vec3 in_normal;
layout(location = 2) in vec4 in_tangent;
layout(location = 3) in vec4 in_uv;
layout(location = 4) in vec4 in_colour;
layout(location = 5) flat in uint in_chart;
layout(location = 6) in vec2 in_unwrap;
layout(location = 0) out vec4 out_light;
#if GROUPS > 1
layout(location = 1) out vec4 out_second;
#endif
#if GROUPS > 2
layout(location = 2) out vec4 out_third;
#endif
void main() {
  const vec3 n_geometric = normalize(in_normal);
  const ShadingPoint s = ShadingPoint(in_position_m, n_geometric, in_tangent, in_uv.xy, in_uv.zw, in_colour);
  const vec3 n = mapped_normal(material.maps[MAP_NORMAL], map_normal, s);
  const LitThrough r = lit_through(s, n, n_geometric, skin_specular(s), unseen);

  const float chart = cut_out ? chart_left(float(in_chart), in_uv, in_colour) : float(in_chart);
  vec3 albedo = skin_albedo(s);
  if (cut_out && chart == BORDER_ALPHA) albedo = albedo_beside(in_uv, in_colour);

  const vec3 before = albedo_power(albedo, material.mix_before);
  const float scale = frame.radiance_scale / pi;
  const vec3 entering = r.skin.entering + entering_surroundings(s, n, in_unwrap);

  if (cut_out && chart == 0.0) discard;
  out_light = vec4(storable((entering * before + joining(r, 0)) * scale), chart);
#if GROUPS > 1
  out_second = vec4(storable(joining(r, 1) * scale), chart);
#endif
#if GROUPS > 2
  out_third = vec4(storable(joining(r, 2) * scale), chart);
#endif
}
