// SPDX-License-Identifier: MIT
// Finds texels of the light map that hold skin after the alpha test. Follows skin_point.glsl.
#include "render/shaders/cut_out.glsl"
#include "render/shared/gutters_io.h"
layout(binding = 32) uniform sampler2D map_alpha_max;  // render/passes/asset/alpha_max.h

// A texel of the light map as the alpha test sees it.
struct CutTexel {
  vec4 uv;  // both sets of texture coordinates
  vec4 colour;
  // Change of alpha_uv() and of the colour's alpha from the centre to a corner of two by two texels.
  vec2 uv_reach;
  float alpha_reach;
};

// A bilinear read of alpha includes half a pixel more.
vec2 reach_of(CutTexel t) { return t.uv_reach + 0.5 / vec2(textureSize(map_alpha_max, 0)); }

// Returns whether any skin is left within a texel of the light map. Nine reads, at most a texel of their
// level apart, miss no pixel.
bool is_beside_skin(CutTexel t) {
  const vec2 at = alpha_uv(t.uv), size = vec2(textureSize(map_alpha_max, 0));
  const vec2 reach = reach_of(t);
  const float level = max(ceil(log2(max(reach.x * size.x, reach.y * size.y))), 0.0);
  float alpha = 0.0;
  for (int k = 0; k < 9; ++k)
    alpha = max(alpha, textureLod(map_alpha_max, at + reach * vec2(k % 3 - 1, k / 3 - 1), level).r);
  const float factor = material.base_colour.a * (t.colour.a + t.alpha_reach);
  return alpha * factor + 1.0 / 1024.0 >= material.alpha_cutoff;
}

// Returns the chart of a texel. A texel whose centre is cut away, but that a visible pixel may read, is lit
// for those reads only: convolutions skip it. 0: nothing is there.
float chart_left(float chart, CutTexel t) {
  const bool beside = is_beside_skin(t);
  if (!is_cut(t.uv, t.colour)) return chart;
  return beside ? BORDER_ALPHA : 0.0;
}

// Returns the colour of the skin left beside a texel that is cut away, where the map may hold anything: its
// mip levels weigh colours by alpha.
vec3 albedo_beside(CutTexel t) {
  if (is_on(frame.white_albedo)) return vec3(1.0);
  const vec2 at = alpha_uv(t.uv), pixels = reach_of(t) * vec2(textureSize(map_alpha_max, 0));
  return material.base_colour.rgb * t.colour.rgb *
         textureLod(map_base_colour, at, log2(max(pixels.x, pixels.y)) + 2.0).rgb;
}

#ifdef COMPUTE_SHADING
CutTexel cut_texel(ShadingPoint s, float alpha_reach) {
  const vec2 offset = material.maps[MAP_BASE_COLOUR].offset;
  return CutTexel(vec4(s.uv0, s.uv1), s.colour,
                  abs(alpha_uv(s.uv_dx) - offset) + abs(alpha_uv(s.uv_dy) - offset), alpha_reach);
}
#else
CutTexel cut_texel(vec4 uv, vec4 colour) {
  const vec2 at = alpha_uv(uv);
  return CutTexel(uv, colour, abs(dFdx(at)) + abs(dFdy(at)), abs(dFdx(colour.a)) + abs(dFdy(colour.a)));
}
#endif
