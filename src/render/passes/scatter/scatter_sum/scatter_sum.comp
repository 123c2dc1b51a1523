// SPDX-License-Identifier: MIT
// Adds up the blurred light of a texel: sum_i w_i (light blurred by term i), w_i the part of the term that is
// read from its map there. The next layer has the rest of the weights to 1. Alpha: 1 where there is skin,
// BORDER_ALPHA beside an open border, 0 where nothing was lit.
#version 460
#include "render/passes/scatter/scatter_sum/scatter_sum_io.h"
#include "render/shaders/half.glsl"
#include "render/shaders/map_read.glsl"
layout(local_size_x = 16, local_size_y = 8) in;
layout(constant_id = 0) const int term_count = 6;
layout(constant_id = 1) const bool mixed = false;  // SkinLook::mixes
layout(push_constant, scalar) uniform Push { ScatterSumIo io; };
layout(binding = 0) uniform sampler2D light_0;
layout(binding = 1) uniform sampler2D light_1;
layout(binding = 2) uniform sampler2D light_2;
layout(binding = 3) uniform sampler2D light_3;
layout(binding = 4) uniform sampler2D light_4;
layout(binding = 5) uniform sampler2D light_5;
layout(binding = 6) uniform sampler2D light_6;
layout(binding = 7) uniform sampler2D light_7;
layout(binding = 8) uniform sampler2D widest;  // of the terms: read in every frame that has light
layout(binding = 9) uniform sampler2D stretch;
layout(binding = 10, scalar) uniform Terms { SummedTermsIo terms; };
layout(binding = 11, rgba16f) uniform writeonly image2DArray sum_out;

// Returns texture coordinates per mm, the geometric mean of both directions. The metric does not depend on T,
// nor does the size of its map.
float uv_per_mm_at(uvec2 texel) {
  const ivec2 at = ivec2((vec2(texel) + 0.5) * (float(textureSize(stretch, 0).x) / float(io.side)));
  const vec2 factor = texelFetch(stretch, at, 0).xz * 0.001;  // diagonal of the Cholesky factor
  return sqrt(max(factor.x * factor.y, 0.0));
}

struct Sum {
  vec3 light, rest;
};

// A map whose term is not read may hold anything: 0 times NaN is NaN.
void add(inout Sum sum, int i, sampler2D light, ivec2 at, float uv_per_mm) {
  if (i >= term_count || io.shares[i] == 0.0) return;
  const float here = mixed ? map_share(terms.sigma_mm[i], io.shown_mm, uv_per_mm, io.side) : 1.0;
  const vec3 weight = here * io.shares[i] * terms.weights[i];
  sum.light += weight * texelFetch(light, at, 0).rgb;
  sum.rest -= weight;
}

void main() {
  const uvec2 p = gl_GlobalInvocationID.xy;
  if (any(greaterThanEqual(p, uvec2(io.side)))) return;

  const ivec2 at = ivec2(io.origin + p);
  const float uv_per_mm = uv_per_mm_at(p);
  Sum sum = Sum(vec3(0.0), vec3(1.0));
  add(sum, 0, light_0, at, uv_per_mm);
  add(sum, 1, light_1, at, uv_per_mm);
  add(sum, 2, light_2, at, uv_per_mm);
  add(sum, 3, light_3, at, uv_per_mm);
  add(sum, 4, light_4, at, uv_per_mm);
  add(sum, 5, light_5, at, uv_per_mm);
  add(sum, 6, light_6, at, uv_per_mm);
  add(sum, 7, light_7, at, uv_per_mm);

  const float chart = texelFetch(widest, at, 0).a;
  const float alpha = chart == 0.0 ? 0.0 : chart == BORDER_ALPHA ? BORDER_ALPHA : 1.0;
  imageStore(sum_out, ivec3(at, int(io.layer)), vec4(storable(sum.light), alpha));
  imageStore(sum_out, ivec3(at, int(io.layer) + 1), vec4(storable(sum.rest), alpha));
}
