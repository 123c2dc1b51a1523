// SPDX-License-Identifier: MIT
// Writes the entries of each pixel to their places in the list.
#version 460
#include "passes/entries/entries_io.h"
#include "shared/scene_io.h"
layout(local_size_x = 64) in;
layout(push_constant, scalar) uniform Push { EntryListIo io; };
layout(binding = 0, scalar) readonly buffer Pixels { PixelIo pixels[]; };
layout(binding = 1, scalar) buffer Entries { EntryIo entries[]; };

void list(uint id, uint rank, uint pixel, uint samples) {
  const uint first = entries[(id >> ID_TRIANGLE_BITS) - 1u].x;
  entries[first + rank] = EntryIo(id, pixel | samples << RANK_BITS);
}

void main() {
  if (gl_GlobalInvocationID.x >= io.size.x) return;
  const uvec2 at = io.low + gl_GlobalInvocationID.xy;
  const uint pixel = at.y * io.width + at.x;
  const uint ranks = pixels[pixel].rank_first, samples = ranks >> RANK_BITS;
  if ((samples & 15u) != 0u) list(pixels[pixel].first, ranks & (1u << RANK_BITS) - 1u, pixel, samples & 15u);
  if (samples >> 4 != 0u) list(pixels[pixel].second, pixels[pixel].rank_second, pixel, samples >> 4);
}
