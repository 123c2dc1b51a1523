// SPDX-License-Identifier: MIT
// A Gaussian along x, then along y, cut off at three sigma and divided by its total. Each workgroup blurs the
// rows that its pixels need along x, and keeps them in shared memory.
#version 460
#include "render/shared/types.h"
#include "render/shaders/half.glsl"
#include "render/passes/finish/bloom/bloom_io.h"
layout(local_size_x = BLOOM_WIDTH, local_size_y = BLOOM_ROWS_AT_ONCE) in;
layout(push_constant, scalar) uniform Push { BloomIo io; };
layout(binding = 0, rgba16f) uniform readonly image2D picture;
layout(binding = 2, rgba16f) uniform writeonly image2D target;

// Red and green, and blue, as half floats.
shared uvec2 along_x[(BLOOM_HEIGHT + 2 * BLOOM_MOST_REACH) * BLOOM_WIDTH];

vec3 row_at(int row) {
  const uvec2 halves = along_x[row * BLOOM_WIDTH + int(gl_LocalInvocationID.x)];
  return vec3(unpackHalf2x16(halves.x), unpackHalf2x16(halves.y).x);
}
void keep_row(int row, vec3 light) {
  along_x[row * BLOOM_WIDTH + int(gl_LocalInvocationID.x)] =
      uvec2(packHalf2x16(light.rg), packHalf2x16(vec2(light.b, 0.0)));
}

void main() {
  const ivec2 last = imageSize(picture) - 1;
  const int x = int(gl_GlobalInvocationID.x), top = int(gl_WorkGroupID.y) * BLOOM_HEIGHT;
  const int reach = min(int(ceil(3.0 * io.sigma)), BLOOM_MOST_REACH);
  const int rows = min(BLOOM_HEIGHT, last.y + 1 - top);

  // exp(-k^2 / 2 sigma^2) from one k to the next: times ratio, and ratio times g^2.
  const float g = exp(-0.5 / (io.sigma * io.sigma));
  float total = 1.0, w = 1.0, ratio = g;
  for (int k = 1; k <= reach; ++k, ratio *= g * g) {
    w *= ratio;
    total += 2.0 * w;
  }

  for (int row = int(gl_LocalInvocationID.y); row < rows + 2 * reach; row += BLOOM_ROWS_AT_ONCE) {
    const int y = clamp(top + row - reach, 0, last.y);
    vec3 sum = imageLoad(picture, ivec2(min(x, last.x), y)).rgb;
    w = 1.0, ratio = g;
    for (int k = 1; k <= reach; ++k, ratio *= g * g) {
      w *= ratio;
      sum += w * (imageLoad(picture, ivec2(min(x + k, last.x), y)).rgb +
                  imageLoad(picture, ivec2(clamp(x - k, 0, last.x), y)).rgb);
    }
    keep_row(row, storable(sum / total));
  }
  barrier();

  if (x > last.x) return;
  for (int row = int(gl_LocalInvocationID.y); row < rows; row += BLOOM_ROWS_AT_ONCE) {
    vec3 sum = row_at(row + reach);
    w = 1.0, ratio = g;
    for (int k = 1; k <= reach; ++k, ratio *= g * g) {
      w *= ratio;
      sum += w * (row_at(row + reach + k) + row_at(row + reach - k));
    }
    imageStore(target, ivec2(x, top + row), vec4(storable(sum / total), 0.0));
  }
}
