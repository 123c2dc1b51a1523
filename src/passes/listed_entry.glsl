// SPDX-License-Identifier: MIT
// The entries that a dispatch shades: those of one part in a band, an invocation for each. Common part of the
// shaders that shade them.
#include "passes/shaded_entry.glsl"
layout(local_size_x = ENTRY_GROUP) in;
layout(binding = 25, scalar) readonly buffer List { uint list[]; };
layout(binding = 38, rg32ui) uniform uimage2DArray entries_of_pixels;

struct Entry {
  ivec3 at;              // pixel, and which of its entries
  uint triangle;         // of its part
  uint samples;          // as bits
  uint second_triangle;  // which the last sample shows, if it is the only entry of the pixel
};

// Returns whether a surface covers all of its pixel.
bool is_whole(Entry entry, bool multisampled) { return !multisampled || entry.samples == 15u; }

// Returns whether there is an entry of the part for this invocation, and its place in the list.
bool find_listed(uint part, out uint place) {
  const uint number =
      (gl_WorkGroupID.y * ENTRY_ROW + gl_WorkGroupID.x) * ENTRY_GROUP + gl_LocalInvocationIndex;
  place = list[2u * part] + number;  // a PartRangeIo
  return number < list[2u * part + 1u];
}

uint triangle_at(ivec3 at) { return imageLoad(entries_of_pixels, at).x & (1u << ID_TRIANGLE_BITS) - 1u; }

// first_row: of the band
Entry listed(uint word, uint width, uint first_row) {
  const uint pixel = word & (1u << PIXEL_BITS) - 1u;
  const ivec3 at = ivec3(pixel % width, first_row + pixel / width, word >> PIXEL_BITS & 3u);
  const uint samples = word >> LISTED_SAMPLES_SHIFT & 15u, triangle = triangle_at(at);
  return Entry(at, triangle, samples, samples == 15u ? triangle_at(at + ivec3(0, 0, 1)) : triangle);
}
