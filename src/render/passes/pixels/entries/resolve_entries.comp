// SPDX-License-Identifier: MIT
// The mean over a pixel of the light of its entries, and of what lies over them. Alpha: share of the pixel
// that is skin. LAYER: 0, none; 1, one sample; 4, four.
// Variant resolve_entries_layer.comp: LAYER=4
// Variant resolve_entries_layer_single.comp: LAYER=1
#version 460
#ifndef LAYER
#define LAYER 0
#endif
#include "render/passes/pixels/shaded_entry.glsl"
#include "render/passes/pixels/pixel_area_io.h"
#include "render/shaders/half.glsl"
layout(local_size_x = 64) in;
layout(constant_id = 0) const int sample_count = 4;
layout(push_constant, scalar) uniform Push { PixelAreaIo io; };
layout(binding = 0, r32ui) uniform readonly uimage2D samples_of_pixels;
layout(binding = 1, rg32ui) uniform readonly uimage2DArray entries_of_pixels;
layout(binding = 2, rgba16f) uniform writeonly image2D picture;
#if LAYER == 4
layout(binding = 3) uniform sampler2DMS layer;
#elif LAYER == 1
layout(binding = 3) uniform sampler2D layer;
#endif

void main() {
  if (gl_GlobalInvocationID.x >= io.size.x) return;
  const ivec2 at = ivec2(io.low + gl_GlobalInvocationID.xy);
  const uint samples = samples_in(imageLoad(samples_of_pixels, at).x);

  // Share of each sample through which the skin is seen.
  vec4 sum = vec4(0.0), seen = vec4(1.0);
#if LAYER != 0
  for (int s = 0; s < sample_count; ++s) {
    const vec4 over = texelFetch(layer, at, s);
    sum.rgb += over.rgb;
    seen[s] = 1.0 - over.a;
  }
#endif

  int e = 0;
  for (uint left = samples; left != 0u; left >>= 4, ++e) {
    const vec3 light = radiance_of(imageLoad(entries_of_pixels, ivec3(at, e)).xy);
    const float share = dot(seen, vec4(left & 1u, left >> 1 & 1u, left >> 2 & 1u, left >> 3 & 1u));
    sum += share * vec4(light, 1.0);
  }
  imageStore(picture, at, round_to_half(sum / float(sample_count)));
}
