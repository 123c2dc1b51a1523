// SPDX-License-Identifier: MIT
// Averages squares of pixels into one.
#version 460
#include "render/shared/types.h"
#include "render/shaders/half.glsl"
#include "render/passes/finish/bloom/bloom_io.h"
layout(local_size_x = 8, local_size_y = 8) in;
layout(push_constant, scalar) uniform Push { BloomIo io; };
layout(binding = 0, rgba16f) uniform readonly image2D picture;
layout(binding = 2, rgba16f) uniform writeonly image2D target;

void main() {
  const ivec2 p = ivec2(gl_GlobalInvocationID.xy), last = imageSize(picture) - 1;
  if (any(greaterThanEqual(p, imageSize(target)))) return;

  const int side = 1 << io.halvings;
  vec4 sum = vec4(0.0);
  for (int y = 0; y < side; ++y)
    for (int x = 0; x < side; ++x) sum += imageLoad(picture, min(side * p + ivec2(x, y), last));
  imageStore(target, p, vec4(storable(sum.rgb / float(side * side)), 0.0));
}
