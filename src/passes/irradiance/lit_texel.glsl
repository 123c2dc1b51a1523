// SPDX-License-Identifier: MIT
// Light of a texel, E albedo^mix / pi 2^EV: the input of the convolution, for raster and compute passes
// alike. GROUPS: of the profile's terms that transmitted light joins, each with a target
// (passes/transmission.h); 0: no transmitted light. Alpha is the number of the chart; BORDER_ALPHA where the
// alpha test cuts the skin away.
#include "shaders/half.glsl"
#include "shaders/skin_point.glsl"
#include "shaders/skin_lights.glsl"
#if GROUPS > 0
#include "shaders/skin_through.glsl"
#define TARGETS GROUPS
#else
#define TARGETS 1
#endif
#include "shaders/cut_chart.glsl"

struct LitTexel {
  vec4 group[TARGETS];
};

// Needs s.normal to be unit. `unwrap`: texture coordinates of the light map.
LitTexel lit_texel(ShadingPoint s, vec2 unwrap, float chart_there, CutTexel cut) {
  const vec3 n = mapped_normal(material.maps[MAP_NORMAL], map_normal, s);
#if GROUPS > 0
  const LitThrough r = lit_through(s, n, skin_specular(s), unseen);
#endif

  // Pixels of skin beside it read what is cut away.
  const bool cut_away = cut_out && is_cut(cut.uv, cut.colour);
  const float chart = cut_away ? BORDER_ALPHA : chart_there;
  vec3 albedo = skin_albedo(s);
  if (cut_away) albedo = albedo_beside(cut);
  const vec3 before = albedo_power(albedo, material.mix_before);
  const float scale = frame.radiance_scale / pi;

  LitTexel lit;
#if GROUPS > 0
  const vec3 entering = r.skin.entering + entering_surroundings(s, n, unwrap);
  lit.group[0] = vec4(storable((entering * before + joining(r, 0)) * scale), chart);
#if GROUPS > 1
  for (int g = 1; g < GROUPS; ++g) lit.group[g] = vec4(storable(joining(r, g) * scale), chart);
#endif
#else
  const vec3 entering =
      lit_skin(s, n, skin_specular(s), true, unseen).entering + entering_surroundings(s, n, unwrap);
  lit.group[0] = vec4(storable(entering * before * scale), chart);
#endif
  return lit;
}
