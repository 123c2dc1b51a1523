// SPDX-License-Identifier: MIT
// Light of a texel, E albedo^mix / pi 2^EV: the input of the convolution.
// GROUPS: of the profile's terms that transmitted light joins, each with a target
// (render/passes/light_map/transmission.h); 0: no transmitted light. Alpha is the number of the chart;
// BORDER_ALPHA where the alpha test cuts the skin away. Texels that are not written stay unlit.
// Variant irradiance_through_1.comp: GROUPS=1
// Variant irradiance_through_2.comp: GROUPS=2
// Variant irradiance_through_3.comp: GROUPS=3
#version 460
#ifndef GROUPS
#define GROUPS 0
#endif

#define COMPUTE_SHADING
#include "render/shared/scene_io.h"
#include "render/shaders/half.glsl"
#include "render/shaders/skin_point.glsl"
#if GROUPS > 0
#include "render/shaders/transmission.glsl"
#define TARGETS GROUPS
#else
#define TARGETS 1
#endif
#include "render/shaders/cut_chart.glsl"
#include "render/passes/light_map/irradiance/albedo_before.glsl"
#include "render/passes/light_map/irradiance/texel.glsl"

layout(binding = 36, rgba16f) uniform writeonly image2D light;
#if GROUPS > 0
layout(binding = 42, rgba16f) uniform writeonly image2D entered_light;
layout(constant_id = 25) const bool stores_entered = false;
#endif
#if GROUPS > 1
layout(binding = 37, rgba16f) uniform writeonly image2D joining_1;
#endif
#if GROUPS > 2
layout(binding = 38, rgba16f) uniform writeonly image2D joining_2;
#endif

struct LitTexel {
  vec4 group[TARGETS];
  vec4 entered;  // without transmitted light
};

// Needs s.normal to be unit. `unwrap`: texture coordinates of the light map.
LitTexel lit_texel(ShadingPoint s, vec2 unwrap, float chart_there, CutTexel cut) {
  const vec3 n = mapped_normal(material.maps[MAP_NORMAL], map_normal, s);
#if GROUPS > 0
  const LitThrough r = lit_through(s, n, skin_specular(s), unseen);
#endif

  const vec4 before = albedo_before(s, chart_there, cut);
  const float chart = before.a;
  const float scale = frame.radiance_scale / pi;

  LitTexel lit;
#if GROUPS > 0
  const vec3 entering = r.skin.entering + entering_surroundings(s, n, unwrap);
  lit.group[0] = vec4(storable((entering * before.rgb + joining(r, 0)) * scale), chart);
  lit.entered = vec4(storable(entering * before.rgb * scale), chart);
#if GROUPS > 1
  for (int g = 1; g < GROUPS; ++g) lit.group[g] = vec4(storable(joining(r, g) * scale), chart);
#endif
#else
  const vec3 entering =
      lit_skin(s, n, skin_specular(s), true, unseen).entering + entering_surroundings(s, n, unwrap);
  lit.group[0] = lit.entered = vec4(storable(entering * before.rgb * scale), chart);
#endif
  return lit;
}

void main() {
  const ListedTexel listed = listed_texel();
  if (!listed.listed) return;
  const Corners k = corners_at(corners_of(listed.triangle), listed.texel);
  const TexelPoint t = texel_point(k);
  const LitTexel lit = lit_texel(t.s, k.centre, t.chart, cut_texel(t.s, t.alpha_reach));

  const ivec2 p = listed.texel + ivec2(io.origin);
  imageStore(light, p, lit.group[0]);
#if GROUPS > 0
  if (stores_entered) imageStore(entered_light, p, lit.entered);
#endif
#if GROUPS > 1
  imageStore(joining_1, p, lit.group[1]);
#endif
#if GROUPS > 2
  imageStore(joining_2, p, lit.group[2]);
#endif
}
