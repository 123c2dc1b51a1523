// SPDX-License-Identifier: MIT
// Adds up the blurred light of a texel: sum_i w_i (light blurred by term i). Alpha: 1 where there is skin,
// BORDER_ALPHA beside an open border, 0 where nothing was lit.
#version 460
#include "render/passes/scatter/scatter_sum/scatter_sum_io.h"
#include "render/shaders/half.glsl"
#include "render/shared/gutters_io.h"
layout(local_size_x = 16, local_size_y = 8) in;
layout(constant_id = 0) const int term_count = 6;
layout(push_constant, scalar) uniform Push { ScatterSumIo io; };
layout(binding = 0) uniform sampler2D light_0;
layout(binding = 1) uniform sampler2D light_1;
layout(binding = 2) uniform sampler2D light_2;
layout(binding = 3) uniform sampler2D light_3;
layout(binding = 4) uniform sampler2D light_4;
layout(binding = 5) uniform sampler2D light_5;
layout(binding = 6) uniform sampler2D light_6;
layout(binding = 7) uniform sampler2D light_7;
layout(binding = 8, rgba16f) uniform writeonly image2DArray sum_out;

vec3 light_of(sampler2D light, uvec2 texel) { return texelFetch(light, ivec2(io.origin + texel), 0).rgb; }

void main() {
  const uvec2 p = gl_GlobalInvocationID.xy;
  if (any(greaterThanEqual(p, uvec2(io.side)))) return;

  vec3 sum = io.weights[0] * light_of(light_0, p);
  if (term_count > 1) sum += io.weights[1] * light_of(light_1, p);
  if (term_count > 2) sum += io.weights[2] * light_of(light_2, p);
  if (term_count > 3) sum += io.weights[3] * light_of(light_3, p);
  if (term_count > 4) sum += io.weights[4] * light_of(light_4, p);
  if (term_count > 5) sum += io.weights[5] * light_of(light_5, p);
  if (term_count > 6) sum += io.weights[6] * light_of(light_6, p);
  if (term_count > 7) sum += io.weights[7] * light_of(light_7, p);

  const float chart = texelFetch(light_0, ivec2(io.origin + p), 0).a;
  const float alpha = chart == 0.0 ? 0.0 : chart == BORDER_ALPHA ? BORDER_ALPHA : 1.0;
  imageStore(sum_out, ivec3(ivec2(io.origin + p), int(io.layer)), vec4(storable(sum), alpha));
}
