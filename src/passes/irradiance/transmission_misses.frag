// SPDX-License-Identifier: MIT
// Counts over the texels that are drawn.
#version 460
#include "shared/scene_io.h"
#include "shaders/half.glsl"
#include "shaders/skin_point.glsl"
#include "shaders/skin_lights.glsl"
#include "shaders/skin_through.glsl"
#include "passes/irradiance/misses.glsl"
layout(location = 0) in vec3 in_position_m;
layout(location = 1) in vec3 in_normal;

void main() {
  ShadingPoint s;  // misses are of sides that face away, which are not moved: no more is read
  s.position_m = s.shadow_m = in_position_m;
  s.normal = normalize(in_normal);
  s.bulge_m = 0.0;
  const uint misses = misses_at(s);
  if (misses > 0u) atomicAdd(counters[slot], misses);
}
