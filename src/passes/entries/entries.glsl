// SPDX-License-Identifier: MIT
// Finds the entries of each pixel, and counts those of each part. MULTISAMPLED: four samples per pixel.
#include "passes/entries/entries_io.h"
layout(local_size_x = 8, local_size_y = 8) in;
layout(push_constant, scalar) uniform Push { EntriesIo io; };
#ifdef MULTISAMPLED
layout(binding = 0) uniform sampler2DMS ids;
layout(binding = 1) uniform sampler2DMS depths;
#else
layout(binding = 0) uniform sampler2D ids;
#endif
layout(binding = 2, scalar) writeonly buffer Pixels { PixelIo pixels[]; };
layout(binding = 3, scalar) buffer Parts { PartIo parts[]; };

// Samples are bits. An entry without samples is none.
struct PixelEntries {
  uint first, second;  // ids
  uint samples_first, samples_second;
};

#ifdef MULTISAMPLED
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
  if (third == 0u) return PixelEntries(id_first, 0u, covered, 0u);
  // Of four triangles two samples each.
  if (bitCount(shown) == 1 && bitCount(third) == 2) {
    shown |= 1u << findMSB(third);
    others = covered & ~shown;
  }
  return PixelEntries(id_first, id_second, shown, others);
}

PixelEntries find_entries(ivec2 at) {
  const vec4 a = texelFetch(ids, at, 0), b = texelFetch(ids, at, 1), c = texelFetch(ids, at, 2),
             d = texelFetch(ids, at, 3);
  const uint id_a = packUnorm4x8(a);
  if (a == b && a == c && a == d) return PixelEntries(id_a, 0u, id_a != 0u ? 15u : 0u, 0u);

  const uvec4 id = uvec4(id_a, packUnorm4x8(b), packUnorm4x8(c), packUnorm4x8(d));
  vec4 distance_m;
  uint covered = 0u;
  for (int s = 0; s < 4; ++s) {
    distance_m[s] = view_distance(texelFetch(depths, at, s).x);
    covered |= id[s] != 0u ? 1u << s : 0u;
  }
  uvec4 besides;
  for (int s = 0; s < 4; ++s) besides[s] = beside(s, id, distance_m);

  const int first = seed_of(besides, covered);
  uint samples_first = besides[first] & covered;
  const uint id_first = most_shown(id, samples_first), left = covered & ~samples_first;
  if (left == 0u) return split(id, id_first, covered);

  // What belongs to neither joins the nearer one.
  const int second = seed_of(besides, left);
  const uint samples_second = besides[second] & left;
  for (int s = 0; s < 4; ++s)
    if ((left & ~samples_second & 1u << s) != 0u &&
        abs(distance_m[s] - distance_m[first]) <= abs(distance_m[s] - distance_m[second]))
      samples_first |= 1u << s;
  return PixelEntries(id_first, most_shown(id, samples_second), samples_first, covered & ~samples_first);
}
#else
PixelEntries find_entries(ivec2 at) {
  const uint id = packUnorm4x8(texelFetch(ids, at, 0));
  return PixelEntries(id, 0u, id != 0u ? 1u : 0u, 0u);
}
#endif

// Counts an entry and returns its rank.
uint rank_of(uint id) { return atomicAdd(parts[(id >> ID_TRIANGLE_BITS) - 1u].count, 1u); }

void main() {
  if (any(greaterThanEqual(gl_GlobalInvocationID.xy, io.size))) return;
  const uvec2 at = io.low + gl_GlobalInvocationID.xy;
  const uint pixel = at.y * io.width + at.x;

  const PixelEntries e = find_entries(ivec2(at));
  const uint samples = e.samples_first | e.samples_second << 4;
  if (samples == 0u) {
    pixels[pixel].rank_first = 0u;
    return;
  }
  const uint rank_first = rank_of(e.first), rank_second = e.samples_second != 0u ? rank_of(e.second) : 0u;
  pixels[pixel] = PixelIo(e.first, e.second, rank_first | samples << RANK_BITS, rank_second);
}
