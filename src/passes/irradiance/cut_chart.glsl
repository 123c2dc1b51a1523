// SPDX-License-Identifier: MIT
// Finds texels of the light map that hold skin after the alpha test. Follows skin_point.glsl.
#include "shaders/cut_out.glsl"
#include "shared/gutters_io.h"
layout(binding = 32) uniform sampler2D map_alpha_max;  // passes/alpha_max.h

vec2 reach_of(vec2 at) { return abs(dFdx(at)) + abs(dFdy(at)) + 0.5 / vec2(textureSize(map_alpha_max, 0)); }

// Returns whether any skin is left within a texel of the light map. Nine reads, at most a texel of their
// level apart, miss no pixel.
bool is_beside_skin(vec4 uv, vec4 colour) {
  const vec2 at = alpha_uv(uv), size = vec2(textureSize(map_alpha_max, 0));
  const vec2 reach = reach_of(at);  // a bilinear read of alpha includes half a pixel more
  const float level = max(ceil(log2(max(reach.x * size.x, reach.y * size.y))), 0.0);
  float alpha = 0.0;
  for (int k = 0; k < 9; ++k)
    alpha = max(alpha, textureLod(map_alpha_max, at + reach * vec2(k % 3 - 1, k / 3 - 1), level).r);
  const float factor = material.base_colour.a * (colour.a + abs(dFdx(colour.a)) + abs(dFdy(colour.a)));
  return alpha * factor + 1.0 / 1024.0 >= material.alpha_cutoff;
}

// Returns the chart of a texel. A texel whose centre is cut away, but that a visible pixel may read, is lit
// for those reads only: convolutions skip it. 0: nothing is there.
float chart_left(float chart, vec4 uv, vec4 colour) {
  const bool beside = is_beside_skin(uv, colour);
  if (!is_cut(uv, colour)) return chart;
  return beside ? BORDER_ALPHA : 0.0;
}

// Returns the colour of the skin left beside a texel that is cut away, where the map may hold anything: its
// mip levels weigh colours by alpha.
vec3 albedo_beside(vec4 uv, vec4 colour) {
  if (is_on(frame.white_albedo)) return vec3(1.0);
  const vec2 at = alpha_uv(uv), pixels = reach_of(at) * vec2(textureSize(map_alpha_max, 0));
  return material.base_colour.rgb * colour.rgb *
         textureLod(map_base_colour, at, log2(max(pixels.x, pixels.y)) + 2.0).rgb;
}
