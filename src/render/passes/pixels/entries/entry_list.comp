// SPDX-License-Identifier: MIT
// Writes the entries of each pixel of a band to their places in its list.
#version 460
#include "render/passes/pixels/entries/entries_io.h"
#include "render/passes/pixels/shaded_entry.glsl"
layout(local_size_x = 64) in;
layout(push_constant, scalar) uniform Push { EntryListIo io; };
layout(binding = 0, r32ui) uniform readonly uimage2D samples_of_pixels;
layout(binding = 1, rg32ui) uniform readonly uimage2DArray entries_of_pixels;
layout(binding = 2, scalar) buffer List { uint list[]; };

void main() {
  if (gl_GlobalInvocationID.x >= io.area.size.x) return;
  const uvec2 at = io.area.low + gl_GlobalInvocationID.xy;
  const uint samples = samples_in(imageLoad(samples_of_pixels, ivec2(at)).x);

  uint e = 0u;
  for (uint left = samples; left != 0u; left >>= 4, ++e) {
    const uvec2 entry = imageLoad(entries_of_pixels, ivec3(at, e)).xy;  // id and rank
    const uint first = list[2u * ((entry.x >> ID_TRIANGLE_BITS) - 1u)];
    list[first + entry.y] =
        (at.y - io.first_row) * io.width + at.x | e << PIXEL_BITS | (left & 15u) << LISTED_SAMPLES_SHIFT;
  }
}
