// SPDX-License-Identifier: MIT
// [DLE07] sec. 3.2 and 3.4: light that enters the skin at a texel, E albedo^mix / pi 2^EV, which is what the
// convolutions spread. GROUPS: of the profile's terms that transmitted light joins, each with a target; 0: no
// light comes through (through.comp). Alpha marks what is lit, [JG08] sec. 3; here by the number of the
// chart, so that no convolution reads a neighbouring chart by mistake.
// Variant irradiance_through_1.frag: GROUPS=1
// Variant irradiance_through_2.frag: GROUPS=2
// Variant irradiance_through_3.frag: GROUPS=3
#version 460
#ifndef GROUPS
#define GROUPS 0
#endif
#include "render/shared/scene_io.h"
#include "render/shaders/half.glsl"
#include "render/techniques/published/lobe.glsl"
#include "render/shaders/skin_point.glsl"
#if GROUPS > 0
#include "render/shaders/transmission.glsl"
#endif
#include "render/shaders/cut_chart.glsl"

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
  const vec3 n = mapped_normal(material.maps[MAP_NORMAL], map_normal, s);
#if GROUPS > 0
  const LitThrough through = lit_through(s, n, skin_specular(s), unseen);
  const LitSkin lit = through.skin;
#else
  const LitSkin lit = lit_skin(s, n, skin_specular(s), true, unseen);
#endif

  const CutTexel cut = cut_texel(in_uv, in_colour);
  const float chart = cut_out ? chart_left(float(in_chart), cut) : float(in_chart);
  vec3 albedo = skin_albedo(s);
  if (cut_out && chart == BORDER_ALPHA) albedo = albedo_beside(cut);
  if (cut_out && chart == 0.0) discard;

  // [DLE07] sec. 3.4: a part of the albedo acts before scattering, the rest in final.frag.
  const vec3 entering =
      (lit.entering + entering_surroundings(s, n, in_unwrap)) * albedo_power(albedo, material.mix_before);
  const float scale = frame.radiance_scale / pi;
#if GROUPS > 0
  out_light = vec4(storable((entering + joining(through, 0)) * scale), chart);
#else
  out_light = vec4(storable(entering * scale), chart);
#endif
#if GROUPS > 1
  out_second = vec4(storable(joining(through, 1) * scale), chart);
#endif
#if GROUPS > 2
  out_third = vec4(storable(joining(through, 2) * scale), chart);
#endif
}
