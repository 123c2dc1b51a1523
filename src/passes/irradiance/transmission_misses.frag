// SPDX-License-Identifier: MIT
// For each shaded texel and each light that it faces away from: counts the read if the position is outside
// the light's map, or if entering light was not stored although there is a surface.
#version 460
#include "shared/scene_io.h"
#include "shaders/half.glsl"
#include "shaders/skin_point.glsl"
#include "shaders/skin_lights.glsl"
#include "shaders/skin_through.glsl"
layout(constant_id = 9) const uint slot = 0;
layout(binding = 25, scalar) buffer Counters { uint counters[]; };
layout(location = 0) in vec3 in_position_m;
layout(location = 1) in vec3 in_normal;

void main() {
  const vec3 n = normalize(in_normal);
  uint misses = 0u;
  for (uint k = nothing(); k < frame.light_count; ++k) {
    const LightIo light = lights[k];
    const Arriving a = arriving_light(light, in_position_m);
    const float cosine_here = dot(n, a.to_light);
    const LightRead read = read_light(light, a, in_position_m, n, cosine_here);
    if (cosine_here <= 0.0 && light.shadow_layers > 0u && !(read.inside && read.shaded)) ++misses;
  }
  if (misses > 0u) atomicAdd(counters[slot], misses);
}
