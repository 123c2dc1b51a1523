// SPDX-License-Identifier: MIT
// Counts over the texels that are computed.
#version 460
#define COMPUTE
#include "shared/scene_io.h"
#include "shaders/half.glsl"
#include "shaders/skin_point.glsl"
#include "shaders/skin_lights.glsl"
#include "shaders/skin_through.glsl"
#include "shaders/cut_out.glsl"
#include "passes/irradiance/misses.glsl"
#include "passes/irradiance/texel.glsl"

void main() {
  const ivec2 texel = texel_of_invocation();
  if (any(greaterThanEqual(texel, ivec2(io.side)))) return;
  const uint number = texelFetch(texels, texel + ivec2(io.origin), 0).r;  // of the triangle, plus one
  if (number <= io.first_triangle || number > io.end_triangle) return;

  const Corners k = corners_at(corners_of(number - 1u), texel);
  if (!is_seen(k)) return;

  const uint misses = misses_at(k.position_m, texel_point(k).s.normal);
  if (misses > 0u) atomicAdd(counters[slot], misses);
}
