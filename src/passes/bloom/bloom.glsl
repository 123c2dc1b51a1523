// SPDX-License-Identifier: MIT
// One step of bloom, see bloom.h; io.mode says which. Needs `mixed(light, p)`: the light of pixel p with its
// share of the smaller picture.
#include "shared/types.h"
#include "shaders/half.glsl"
#include "passes/bloom/bloom_io.h"
layout(local_size_x = 8, local_size_y = 8) in;
layout(push_constant, scalar) uniform Push { BloomIo io; };
layout(binding = 0, rgba16f) uniform readonly image2D picture;
layout(binding = 2, rgba16f) uniform writeonly image2D target;

// Returns the mean of the four pixels that p covers in the picture of twice the size.
vec4 downsampled(ivec2 p, ivec2 last) {
  vec4 sum = vec4(0.0);
  for (int k = 0; k < 4; ++k) sum += imageLoad(picture, min(2 * p + ivec2(k & 1, k >> 1), last));
  return sum * 0.25;
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
  const ivec2 size = imageSize(target);
  if (any(greaterThanEqual(p, size))) return;

  const ivec2 last = imageSize(picture) - 1;
  vec4 result;
  if (io.mode == BLOOM_DOWNSAMPLE) {
    result = downsampled(p, last);
  } else if (io.mode == BLOOM_COMBINE) {
    result = imageLoad(picture, p);
  } else {
    result = blurred(p, io.mode == BLOOM_BLUR_X ? ivec2(1, 0) : ivec2(0, 1), last);
  }
  imageStore(target, p, vec4(storable(mixed(result.rgb, p)), round_to_half(clamp(result.a, 0.0, 1.0))));
}
