// SPDX-License-Identifier: MIT
// The mean over a pixel of the light of its entries, in the order of its samples, and of what lies over them.
// Alpha: share of the pixel that is skin. LAYER: 0, none; 1, one sample; 4, four.
#include "passes/entries/entries_io.h"
#include "shaders/half.glsl"
layout(local_size_x = 64) in;
layout(constant_id = 0) const int sample_count = 4;
layout(push_constant, scalar) uniform Push { EntryListIo io; };
layout(binding = 0, scalar) readonly buffer Pixels { PixelIo pixels[]; };
layout(binding = 1, scalar) readonly buffer Entries { EntryIo entries[]; };
layout(binding = 2, rgba16f) uniform writeonly image2D picture;
#if LAYER == 4
layout(binding = 3) uniform sampler2DMS layer;
#elif LAYER == 1
layout(binding = 3) uniform sampler2D layer;
#endif

// Returns the light of an entry. Alpha 1 marks skin.
vec4 light_of(uint id, uint rank) {
  const EntryIo entry = entries[entries[(id >> ID_TRIANGLE_BITS) - 1u].x + rank];
  return vec4(unpackHalf2x16(entry.x), unpackHalf2x16(entry.y).x, 1.0);
}

void main() {
  if (gl_GlobalInvocationID.x >= io.size.x) return;
  const ivec2 at = ivec2(io.low + gl_GlobalInvocationID.xy);
  const PixelIo pixel = pixels[uint(at.y) * io.width + uint(at.x)];
  const uint samples = pixel.rank_first >> RANK_BITS;
  vec4 first = vec4(0.0), second = vec4(0.0);
  if ((samples & 15u) != 0u) first = light_of(pixel.first, pixel.rank_first & (1u << RANK_BITS) - 1u);
  if (samples >> 4 != 0u) second = light_of(pixel.second, pixel.rank_second);

#if LAYER == 0
  const vec4 sum = float(bitCount(samples & 15u)) * first + float(bitCount(samples >> 4)) * second;
#else
  vec4 sum = vec4(0.0);
  for (int s = 0; s < sample_count; ++s) {
    const vec4 over = texelFetch(layer, at, s), nothing = vec4(0.0);
    const vec4 skin = (samples >> s & 1u) != 0u ? first : (samples >> (4 + s) & 1u) != 0u ? second : nothing;
    sum += vec4(over.rgb, 0.0) + (1.0 - over.a) * skin;
  }
#endif
  imageStore(picture, at, round_to_half(sum / float(sample_count)));
}
