// SPDX-License-Identifier: MIT
// One texel of the head's light, as irradiance.comp, from irradiance that a host has drawn there. Alpha 0:
// it has not.
#version 460
#define COMPUTE_SHADING
#include "render/shared/scene_io.h"
#include "render/shaders/half.glsl"
#include "render/shaders/skin_point.glsl"
#include "render/shaders/cut_chart.glsl"
#include "render/passes/light_map/irradiance/albedo_before.glsl"
#include "render/passes/light_map/irradiance/texel.glsl"
layout(binding = 24) uniform sampler2D host_irradiance;
layout(binding = 36, rgba16f) uniform writeonly image2D light;

void main() {
  const ListedTexel listed = listed_texel();
  if (!listed.listed) return;
  const ivec2 p = listed.texel + ivec2(io.origin);
  const vec4 e = texelFetch(host_irradiance, p, 0);
  if (e.a == 0.0) return;

  const TexelPoint t = texel_point(corners_at(corners_of(listed.triangle), listed.texel));
  const vec4 before = albedo_before(t.s, t.chart, cut_texel(t.s, t.alpha_reach));
  imageStore(light, p, vec4(storable(e.rgb * before.rgb * (frame.radiance_scale / pi)), before.a));
}
