// SPDX-License-Identifier: MIT
// One texel of the head's light, computed. GROUPS: as lit_texel.glsl.
#define COMPUTE
#include "shared/scene_io.h"
#include "passes/irradiance/lit_texel.glsl"
#include "passes/irradiance/texel.glsl"
layout(binding = 36, rgba16f) uniform writeonly image2D light;
#if GROUPS > 1
layout(binding = 37, rgba16f) uniform writeonly image2D joining_1;
#endif
#if GROUPS > 2
layout(binding = 38, rgba16f) uniform writeonly image2D joining_2;
#endif

void main() {
  const ivec2 texel = texel_of_invocation(), p = texel + ivec2(io.origin);
  if (any(greaterThanEqual(texel, ivec2(io.side)))) return;
  const uint number = texelFetch(texels, p, 0).r;  // of the triangle, plus one
  if (number == 0u ? io.clears == 0u : number <= io.first_triangle || number > io.end_triangle) return;

  LitTexel lit;
  for (int g = 0; g < TARGETS; ++g) lit.group[g] = vec4(0.0);

  if (number > 0u) {
    const Corners k = corners_at(corners_of(number - 1u), texel);
    if (is_seen(k)) {
      const TexelPoint t = texel_point(k);
      lit = lit_texel(t.s, k.centre, t.chart, cut_texel(t.s, t.alpha_reach));
      if (cut_out && lit.group[0].a == 0.0)
        for (int g = 0; g < TARGETS; ++g) lit.group[g] = vec4(0.0);
    }
  }

  imageStore(light, p, lit.group[0]);
#if GROUPS > 1
  imageStore(joining_1, p, lit.group[1]);
#endif
#if GROUPS > 2
  imageStore(joining_2, p, lit.group[2]);
#endif
}
