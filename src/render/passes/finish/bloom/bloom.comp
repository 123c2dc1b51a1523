// SPDX-License-Identifier: MIT
// One step of bloom, see bloom.h; io.mode says which.
#version 460
#include "render/shared/types.h"
#include "render/shaders/half.glsl"
#include "render/passes/finish/bloom/bloom_io.h"
layout(local_size_x = 8, local_size_y = 8) in;
layout(push_constant, scalar) uniform Push { BloomIo io; };
layout(binding = 0, rgba16f) uniform readonly image2D picture;
layout(binding = 2, rgba16f) uniform writeonly image2D target;

// Returns the mean of the pixels that p covers in the picture.
vec4 downsampled(ivec2 p, ivec2 last) {
  const int side = 1 << io.halvings;
  vec4 sum = vec4(0.0);
  for (int y = 0; y < side; ++y)
    for (int x = 0; x < side; ++x) sum += imageLoad(picture, min(side * p + ivec2(x, y), last));
  return sum / float(side * side);
}

// Returns the Gaussian mean along one axis, cut off at three sigma and divided by its total.
vec4 blurred(ivec2 p, ivec2 axis, ivec2 last) {
  const int reach = int(ceil(3.0 * io.sigma));
  vec4 sum = imageLoad(picture, p);
  float total = 1.0;
  // exp(-k^2 / 2 sigma^2), from one k to the next.
  const float g = exp(-0.5 / (io.sigma * io.sigma));
  float w = 1.0, ratio = g;
  for (int k = 1; k <= reach; ++k) {
    w *= ratio;
    ratio *= g * g;
    sum += w * (imageLoad(picture, clamp(p + k * axis, ivec2(0), last)) +
                imageLoad(picture, clamp(p - k * axis, ivec2(0), last)));
    total += 2.0 * w;
  }
  return sum / total;
}

void main() {
  const ivec2 p = ivec2(gl_GlobalInvocationID.xy);
  if (any(greaterThanEqual(p, imageSize(target)))) return;

  const ivec2 last = imageSize(picture) - 1;
  vec4 result;
  if (io.mode == BLOOM_DOWNSAMPLE)
    result = downsampled(p, last);
  else
    result = blurred(p, io.mode == BLOOM_BLUR_X ? ivec2(1, 0) : ivec2(0, 1), last);
  imageStore(target, p, vec4(storable(result.rgb), 0.0));
}
