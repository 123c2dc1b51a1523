// SPDX-License-Identifier: MIT
// Counts, for the statistics, lights that a texel faces away from and whose maps
// do not hold it. Its position is outside, or the light that entered was not stored although there is a
// surface.
#version 460
#include "render/shared/scene_io.h"
#include "render/shaders/half.glsl"
#include "render/techniques/published/lobe.glsl"
#include "render/shaders/skin_point.glsl"
#include "render/shaders/transmission.glsl"
layout(constant_id = 9) const uint slot = 0;
layout(binding = 25, scalar) buffer Counters { uint counters[]; };
layout(location = 0) in vec3 in_position_m;
layout(location = 1) in vec3 in_normal;

void main() {
  ShadingPoint s;  // misses are of sides that face away, which are not moved: no more is read
  s.position_m = s.shadow_m = in_position_m;
  s.normal = normalize(in_normal);
  s.bulge_m = 0.0;

  const uint misses = transmission_misses(s);
  if (misses > 0u) atomicAdd(counters[slot], misses);
}
