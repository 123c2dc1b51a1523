// SPDX-License-Identifier: MIT
// Counts, over the texels that are lit, reads of transmitted light that found nothing.
#version 460
#define COMPUTE_SHADING
#include "render/shared/scene_io.h"
#include "render/shaders/half.glsl"
#include "render/shaders/skin_point.glsl"
#include "render/shaders/transmission.glsl"
#include "render/shaders/cut_out.glsl"
#include "render/passes/light_map/irradiance/texel.glsl"
layout(constant_id = 9) const uint slot = 0;
layout(binding = 25, scalar) buffer Counters { uint counters[]; };

void main() {
  const ListedTexel listed = listed_texel();
  if (!listed.listed) return;
  const Corners k = corners_at(corners_of(listed.triangle), listed.texel);

  const uint misses = transmission_misses(texel_point(k).s);
  if (misses > 0u) atomicAdd(counters[slot], misses);
}
