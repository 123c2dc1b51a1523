// SPDX-License-Identifier: MIT
// Counts, for the statistics, lights that a texel faces away from and whose maps
// do not hold it. Its position is outside, or the light that entered was not stored although there is a
// surface.
#version 460
#include "render/shared/scene_io.h"
#include "render/shaders/half.glsl"
#include "render/techniques/published/lobe.glsl"
#include "render/shaders/skin_point.glsl"
#include "render/shaders/skin_lights.glsl"
#include "render/shaders/skin_through.glsl"
layout(constant_id = 9) const uint slot = 0;
layout(binding = 25, scalar) buffer Counters { uint counters[]; };
layout(location = 0) in vec3 in_position_m;
layout(location = 1) in vec3 in_normal;

void main() {
  ShadingPoint s;  // misses are of sides that face away, which are not moved: no more is read
  s.position_m = s.shadow_m = in_position_m;
  s.normal = normalize(in_normal);
  s.bulge_m = 0.0;

  uint misses = 0u;
  for (uint k = nothing(); k < frame.light_count; ++k) {
    const LightIo light = light_at(k);
    const Arriving a = arriving_light(light, s.position_m);
    const float cosine_here = dot(s.normal, a.to_light);
    const LightRead read = read_light(light, a, s, cosine_here);
    if (cosine_here <= 0.0 && light.shadow_layers > 0u && !(read.inside && read.shaded)) ++misses;
  }
  if (misses > 0u) atomicAdd(counters[slot], misses);
}
