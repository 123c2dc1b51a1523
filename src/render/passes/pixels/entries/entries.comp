// SPDX-License-Identifier: MIT
// Finds the entries of each pixel, and counts those of each part. SINGLE: one sample per pixel, not four.
// Variant entries_single.comp: SINGLE
#version 460
#include "render/passes/pixels/entries/entries_io.h"
layout(local_size_x = 8, local_size_y = 8) in;
layout(push_constant, scalar) uniform Push { EntriesIo io; };
#ifndef SINGLE
layout(binding = 0) uniform sampler2DMS ids;
layout(binding = 1) uniform sampler2DMS depths;
#else
layout(binding = 0) uniform sampler2D ids;
#endif
layout(binding = 2, r32ui) uniform writeonly uimage2D samples_of_pixels;
layout(binding = 3, rg32ui) uniform writeonly uimage2DArray entries_of_pixels;
layout(binding = 4, scalar) buffer Parts { PartIo parts[]; };

// The entries of a pixel: their ids, and their samples as bits. Where one has all samples, the second id is
// that of the last sample.
struct PixelEntries {
  uvec4 ids;
  uint samples;  // of all, four bits each
};

#ifndef SINGLE
// Slope along the view, pixels per pixel, up to which samples are one surface: 76 degrees.
const float most_slope = 4.0;

float view_distance(float depth) {
  return io.orthographic != 0u ? depth * io.factor : io.factor / (depth - io.offset);
}

// Returns the samples that are one surface with sample s.
uint beside(int s, uvec4 id, vec4 distance_m) {
  const float limit = most_slope * io.pixel * (io.orthographic != 0u ? 1.0 : distance_m[s]);
  uint found = 0u;
  for (int k = 0; k < 4; ++k)
    if (id[k] >> ID_TRIANGLE_BITS == id[s] >> ID_TRIANGLE_BITS && abs(distance_m[k] - distance_m[s]) <= limit)
      found |= 1u << k;
  return found;
}

// Returns the sample of `left` that has most of them beside it, of equals the first.
int seed_of(uvec4 besides, uint left) {
  int seed = 0, most = 0;
  for (int s = 0; s < 4; ++s) {
    const int count = (left >> s & 1u) != 0u ? bitCount(besides[s] & left) : 0;
    if (count > most) seed = s;
    most = max(most, count);
  }
  return seed;
}

// Returns the id that most of these samples have, of equals that of the first.
uint most_shown(uvec4 id, uint samples) {
  uvec4 same = uvec4(0u);
  for (int s = 0; s < 4; ++s)
    for (int k = 0; k < 4; ++k)
      if (id[k] == id[s]) same[s] |= 1u << k;
  return id[seed_of(same, samples)];
}

// One surface. Where it shows three triangles or more, far away, two are shaded: else it would flicker.
PixelEntries split(uvec4 id, uint id_first, uint covered) {
  uint shown = 0u, others = 0u;
  for (int s = 0; s < 4; ++s)
    if (id[s] == id_first) shown |= 1u << s;
  shown &= covered;
  others = covered & ~shown;
  const uint id_second = most_shown(id, others);
  uint third = 0u;
  for (int s = 0; s < 4; ++s)
    if ((others >> s & 1u) != 0u && id[s] != id_second) third |= 1u << s;
  if (third == 0u) return PixelEntries(uvec4(id_first, covered == 15u ? id[3] : id_first, 0u, 0u), covered);

  // Of four triangles two samples each.
  if (bitCount(shown) == 1 && bitCount(third) == 2) {
    shown |= 1u << findMSB(third);
    others = covered & ~shown;
  }
  return PixelEntries(uvec4(id_first, id_second, 0u, 0u), shown | others << 4);
}

PixelEntries find_entries(ivec2 at) {
  const vec4 a = texelFetch(ids, at, 0), b = texelFetch(ids, at, 1), c = texelFetch(ids, at, 2),
             d = texelFetch(ids, at, 3);
  const uint id_a = packUnorm4x8(a);
  if (a == b && a == c && a == d) return PixelEntries(uvec4(id_a), id_a != 0u ? 15u : 0u);

  const uvec4 id = uvec4(id_a, packUnorm4x8(b), packUnorm4x8(c), packUnorm4x8(d));
  vec4 distance_m;
  uint covered = 0u;
  for (int s = 0; s < 4; ++s) {
    distance_m[s] = view_distance(texelFetch(depths, at, s).x);
    covered |= id[s] != 0u ? 1u << s : 0u;
  }
  uvec4 besides;
  for (int s = 0; s < 4; ++s) besides[s] = beside(s, id, distance_m);

  // The surface that most samples show is the first.
  PixelEntries found = PixelEntries(uvec4(0u), 0u);
  uint left = covered;
  for (int e = 0; e < 4; ++e) {
    const uint samples = besides[seed_of(besides, left)] & left;
    found.ids[e] = most_shown(id, samples);
    found.samples |= samples << 4 * e;
    left &= ~samples;
  }
  if (found.samples == covered) return split(id, found.ids[0], covered);
  return found;
}
#else
PixelEntries find_entries(ivec2 at) {
  const uint id = packUnorm4x8(texelFetch(ids, at, 0));
  return PixelEntries(uvec4(id), id != 0u ? 1u : 0u);
}
#endif

// Counts an entry and returns its rank among those of its part in the band.
uint rank_of(uint id, uint band) {
  return atomicAdd(parts[band * io.parts + (id >> ID_TRIANGLE_BITS) - 1u].count, 1u);
}

void main() {
  if (any(greaterThanEqual(gl_GlobalInvocationID.xy, io.area.size))) return;
  const ivec2 at = ivec2(io.area.low + gl_GlobalInvocationID.xy);

  const PixelEntries found = find_entries(at);
  const uint part_of_first = found.samples != 0u ? (found.ids.x >> ID_TRIANGLE_BITS) - 1u : 0u;
  imageStore(samples_of_pixels, at, uvec4(found.samples | part_of_first << SAMPLES_BITS));

  if (found.samples == 15u) imageStore(entries_of_pixels, ivec3(at, 1), uvec4(found.ids[1], 0u, 0u, 0u));
  const uint band = uint(at.y) / io.band_rows;
  int e = 0;
  for (uint left = found.samples; left != 0u; left >>= 4, ++e)
    imageStore(entries_of_pixels, ivec3(at, e), uvec4(found.ids[e], rank_of(found.ids[e], band), 0u, 0u));
}
