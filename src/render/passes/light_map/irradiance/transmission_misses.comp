// SPDX-License-Identifier: MIT
// Counts, over the texels that are lit, reads of transmitted light that found nothing.
#version 460
#define COMPUTE_SHADING
#include "render/shared/scene_io.h"
#include "render/shaders/half.glsl"
#include "render/shaders/skin_point.glsl"
#include "render/shaders/skin_lights.glsl"
#include "render/shaders/skin_through.glsl"
#include "render/shaders/cut_out.glsl"
#include "render/passes/light_map/irradiance/texel.glsl"
layout(constant_id = 9) const uint slot = 0;
layout(binding = 25, scalar) buffer Counters { uint counters[]; };

// Returns for how many lights that a point faces away from the position is outside the light's map, or
// entering light was not stored although there is a surface.
uint misses_at(ShadingPoint s) {
  uint misses = 0u;
  for (uint k = nothing(); k < frame.light_count; ++k) {
    const LightIo light = light_at(k);
    const Arriving a = arriving_light(light, s.position_m);
    const float cosine_here = dot(s.normal, a.to_light);
    const LightRead read = read_light(light, a, s, cosine_here);
    if (cosine_here <= 0.0 && light.shadow_layers > 0u && !(read.inside && read.shaded)) ++misses;
  }
  return misses;
}

void main() {
  const ListedTexel listed = listed_texel();
  if (!listed.listed) return;
  const Corners k = corners_at(corners_of(listed.triangle), listed.texel);

  const uint misses = misses_at(texel_point(k).s);
  if (misses > 0u) atomicAdd(counters[slot], misses);
}
