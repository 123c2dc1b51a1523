// SPDX-License-Identifier: MIT
// Counts over the texels that are computed.
#version 460
#define COMPUTE_SHADING
#include "shared/scene_io.h"
#include "shaders/half.glsl"
#include "shaders/skin_point.glsl"
#include "shaders/skin_lights.glsl"
#include "shaders/skin_through.glsl"
#include "shaders/cut_out.glsl"
#include "passes/irradiance/misses.glsl"
#include "passes/irradiance/texel.glsl"

void main() {
  const ListedTexel listed = listed_texel();
  if (!listed.listed) return;
  const Corners k = corners_at(corners_of(listed.triangle), listed.texel);
  if (!is_seen(k)) return;

  const uint misses = misses_at(texel_point(k).s);
  if (misses > 0u) atomicAdd(counters[slot], misses);
}
