// SPDX-License-Identifier: MIT
// Light crosses seams: each texel beside a seam shows what the other chart holds at that point of the skin.
// Sources are texels that the mesh covers, so the order of invocations does not matter.
#version 460
#include "render/shared/gutters_io.h"
#include "render/shaders/half.glsl"
#include "render/shared/types.h"
layout(local_size_x = 64) in;
layout(push_constant, scalar) uniform Push { GuttersIo io; };
layout(binding = 0, scalar) readonly buffer Gutters { GutterIo gutters[]; };
layout(binding = 1, rgba16f) uniform image2D target;

void main() {
  const uint i = gl_GlobalInvocationID.y * GUTTER_ROW + gl_GlobalInvocationID.x;
  if (i >= io.count) return;
  const GutterIo g = gutters[i];
  const ivec2 origin = ivec2(io.origin);
  const ivec2 p = ivec2(g.texel & 0xFFFFu, g.texel >> 16) + origin;

  if (io.mode == 1u) {
    const ivec2 own = ivec2(g.own & 0xFFFFu, g.own >> 16) + origin;
    imageStore(target, p, vec4(imageLoad(target, own).xyz, float(g.chart)));
    return;
  }

  // Mixes the lit texels among the four around the source, as a bilinear read does.
  const vec2 at = g.source - 0.5;
  const ivec2 corner = ivec2(floor(at));
  const vec2 f = at - vec2(corner);
  const ivec2 limit = ivec2(io.side) - 1;

  vec3 sum = vec3(0.0);
  float total = 0.0;
  for (int k = 0; k < 4; ++k) {
    const ivec2 d = ivec2(k & 1, k >> 1);
    const vec4 texel = imageLoad(target, origin + clamp(corner + d, ivec2(0), limit));
    const float weight = (d.x == 1 ? f.x : 1.0 - f.x) * (d.y == 1 ? f.y : 1.0 - f.y) *
                         (texel.a != 0.0 && (g.chart == 0u || texel.a != BORDER_ALPHA) ? 1.0 : 0.0);
    sum += weight * texel.rgb;
    total += weight;
  }

  const float chart = g.chart != 0u ? float(g.chart) : BORDER_ALPHA;
  if (total > 0.0) {
    imageStore(target, p, vec4(round_to_half(sum / total), chart));
    return;
  }

  // If the other chart is unlit there, the texel repeats the light of its own.
  const vec4 beside = imageLoad(target, ivec2(g.own & 0xFFFFu, g.own >> 16) + origin);
  if (g.own != g.texel && beside.a != 0.0) imageStore(target, p, vec4(beside.rgb, chart));
}
