// SPDX-License-Identifier: MIT
// One step of bloom, see bloom.h; io.mode says which.
#version 460
#include "shared/types.h"
#include "shaders/half.glsl"
#include "passes/bloom/bloom_io.h"
layout(local_size_x = 8, local_size_y = 8) in;
layout(push_constant, scalar) uniform Push { BloomIo io; };
layout(binding = 0) uniform sampler2D picture;
layout(binding = 1) uniform sampler2D narrow;
layout(binding = 2) uniform sampler2D wide;
layout(binding = 3, rgba16f) uniform writeonly image2D target;

// Returns the mean of the four pixels that p covers in the picture of twice the size.
vec4 downsampled(ivec2 p, ivec2 last) {
  vec4 sum = vec4(0.0);
  for (int k = 0; k < 4; ++k) sum += texelFetch(picture, min(2 * p + ivec2(k & 1, k >> 1), last), 0);
  return sum * 0.25;
}

// Returns the Gaussian mean along one axis, cut off at three sigma and divided by its total.
vec4 blurred(ivec2 p, ivec2 axis, ivec2 last) {
  const int reach = int(ceil(3.0 * io.sigma));
  vec4 sum = texelFetch(picture, p, 0);
  float total = 1.0;
  for (int k = 1; k <= reach; ++k) {
    const float w = exp(-0.5 * float(k * k) / (io.sigma * io.sigma));
    sum += w * (texelFetch(picture, clamp(p + k * axis, ivec2(0), last), 0) +
                texelFetch(picture, clamp(p - k * axis, ivec2(0), last), 0));
    total += 2.0 * w;
  }
  return sum / total;
}

void main() {
  const ivec2 p = ivec2(gl_GlobalInvocationID.xy);
  const ivec2 size = imageSize(target);
  if (any(greaterThanEqual(p, size))) return;

  const ivec2 last = textureSize(picture, 0) - 1;
  vec4 result;
  if (io.mode == BLOOM_DOWNSAMPLE) {
    result = downsampled(p, last);
  } else if (io.mode == BLOOM_COMBINE) {
    const vec2 uv = (vec2(p) + 0.5) / vec2(size);
    const vec4 sharp = texelFetch(picture, p, 0);
    const vec3 spread =
        io.weight_narrow * textureLod(narrow, uv, 0.0).rgb + io.weight_wide * textureLod(wide, uv, 0.0).rgb;
    result = vec4(mix(sharp.rgb, spread, io.amount), sharp.a);
  } else {
    result = blurred(p, io.mode == BLOOM_BLUR_X ? ivec2(1, 0) : ivec2(0, 1), last);
  }

  imageStore(target, p, vec4(storable(result.rgb), round_to_half(clamp(result.a, 0.0, 1.0))));
}
