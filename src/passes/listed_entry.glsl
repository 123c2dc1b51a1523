// SPDX-License-Identifier: MIT
// The entries that a dispatch shades: those of one part, an invocation for each. Common part of the shaders
// that shade them.
#include "passes/shaded_entry.glsl"
layout(local_size_x = ENTRY_GROUP) in;
layout(binding = 25, scalar) readonly buffer List { uint list[]; };
layout(binding = 38, rg32ui) uniform uimage2DArray entries_of_pixels;

struct Entry {
  ivec3 at;       // pixel, and which of its entries
  uint triangle;  // of its mesh
  uint samples;   // as bits
};

// Returns whether there is an entry of the part for this invocation, and its place in the list.
bool find_listed(uint part, out uint place) {
  const uint number =
      (gl_WorkGroupID.y * ENTRY_ROW + gl_WorkGroupID.x) * ENTRY_GROUP + gl_LocalInvocationIndex;
  place = list[2u * part] + number;  // a PartRangeIo
  return number < list[2u * part + 1u];
}

Entry listed(uint word, uint width) {
  const uint pixel = word & (1u << PIXEL_BITS) - 1u;
  const ivec3 at = ivec3(pixel % width, pixel / width, word >> PIXEL_BITS & 3u);
  return Entry(at, imageLoad(entries_of_pixels, at).x & (1u << ID_TRIANGLE_BITS) - 1u,
               word >> LISTED_SAMPLES_SHIFT & 15u);
}
