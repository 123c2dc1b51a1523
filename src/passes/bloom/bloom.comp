// SPDX-License-Identifier: MIT
// One step of bloom, see bloom.h; io.mode says which.
#version 460
#include "shared/types.h"
#include "shaders/half.glsl"
#include "passes/bloom/bloom_io.h"
layout(local_size_x = 8, local_size_y = 8) in;
layout(push_constant, scalar) uniform Push { BloomIo io; };
layout(binding = 0) uniform sampler2D picture;
layout(binding = 1) uniform sampler2D smaller;
layout(binding = 2, rgba16f) uniform writeonly image2D target;

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
  // exp(-k^2 / 2 sigma^2), from one k to the next.
  const float g = exp(-0.5 / (io.sigma * io.sigma));
  float w = 1.0, ratio = g;
  for (int k = 1; k <= reach; ++k) {
    w *= ratio;
    ratio *= g * g;
    sum += w * (texelFetch(picture, clamp(p + k * axis, ivec2(0), last), 0) +
                texelFetch(picture, clamp(p - k * axis, ivec2(0), last), 0));
    total += 2.0 * w;
  }
  return sum / total;
}

// Returns what the smaller picture holds at pixel p. Halving may reach over the last pixel.
vec3 light_of_smaller(ivec2 p) {
  const vec2 at = (vec2(p) + 0.5) / float(1u << io.halvings);
  return textureLod(smaller, at / vec2(textureSize(smaller, 0)), 0.0).rgb;
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
    result = texelFetch(picture, p, 0);
  } else {
    result = blurred(p, io.mode == BLOOM_BLUR_X ? ivec2(1, 0) : ivec2(0, 1), last);
  }
  if (io.share > 0.0) result.rgb = mix(result.rgb, light_of_smaller(p), io.share);

  imageStore(target, p, vec4(storable(result.rgb), round_to_half(clamp(result.a, 0.0, 1.0))));
}
