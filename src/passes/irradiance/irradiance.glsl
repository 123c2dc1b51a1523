// SPDX-License-Identifier: MIT
// One texel of the head's light; what is not written stays unlit. GROUPS: as lit_texel.glsl.
#define COMPUTE_SHADING
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
  const ListedTexel listed = listed_texel();
  if (!listed.listed) return;
  const Corners k = corners_at(corners_of(listed.triangle), listed.texel);
  const TexelPoint t = texel_point(k);
  const LitTexel lit = lit_texel(t.s, k.centre, t.chart, cut_texel(t.s, t.alpha_reach));

  const ivec2 p = listed.texel + ivec2(io.origin);
  imageStore(light, p, lit.group[0]);
#if GROUPS > 1
  imageStore(joining_1, p, lit.group[1]);
#endif
#if GROUPS > 2
  imageStore(joining_2, p, lit.group[2]);
#endif
}
