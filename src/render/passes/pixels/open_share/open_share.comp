// SPDX-License-Identifier: MIT
// The share of a pixel that no surface covers. SINGLE: it has one sample, else this is the mean over four.
// Variant open_share_single.comp: SINGLE
#version 460
layout(local_size_x = 8, local_size_y = 8) in;
layout(constant_id = 0) const int sample_count = 1;
layout(constant_id = 1) const bool has_layer = false;
#ifndef SINGLE
layout(binding = 0) uniform sampler2DMS depths;
layout(binding = 1) uniform sampler2DMS layer;
#else
layout(binding = 0) uniform sampler2D depths;
layout(binding = 1) uniform sampler2D layer;
#endif
layout(binding = 2, r32f) uniform writeonly image2D open;

void main() {
  const ivec2 p = ivec2(gl_GlobalInvocationID.xy);
  if (any(greaterThanEqual(p, imageSize(open)))) return;

  float sum = 0.0;
  for (int s = 0; s < sample_count; ++s) {
    if (texelFetch(depths, p, s).r > 0.0) continue;
    sum += has_layer ? 1.0 - texelFetch(layer, p, s).a : 1.0;
  }
  imageStore(open, p, vec4(clamp(sum / float(sample_count), 0.0, 1.0)));
}
