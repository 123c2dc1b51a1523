// SPDX-License-Identifier: MIT
// Lists the texels whose triangle is of one material and not culled, or counts them. An invocation looks at a
// run of texels, so that runs stay together in the list, and few atomics are needed. The order of runs
// changes from frame to frame; no bit of the light depends on it.
#version 460
#include "passes/texel_list/texel_list_io.h"
#include "shared/texel_lists_io.h"
layout(local_size_x = 8, local_size_y = 8) in;
layout(push_constant, scalar) uniform Push { ListTexelsIo io; };
layout(binding = 0) uniform usampler2D texels;
layout(binding = 1, scalar) readonly buffer Indices { uint indices[]; };  // GpuMesh::indices, or those kept
layout(binding = 2, scalar) buffer Lists { TexelListIo lists[]; };
layout(binding = 3, r32ui) uniform writeonly uimage2D entries;
layout(constant_id = 0) const bool counts_only = false;
layout(constant_id = 1) const bool counted = false;  // TexelRanges has given the list its place

// Returns whether the texel is listed. A culled triangle has three equal indices.
bool is_lit(uvec2 at) {
  if (at.x >= io.side) return false;
  const uint number = texelFetch(texels, ivec2(io.origin + at), 0).r;  // of the triangle, plus one
  if (number <= io.first_triangle || number > io.end_triangle) return false;
  return indices[3u * number - 3u] != indices[3u * number - 2u];
}

void main() {
  const uvec2 at = gl_GlobalInvocationID.xy * uvec2(TEXEL_RUN, 1u);
  if (at.x >= io.side || at.y >= io.side) return;

  uint lit = 0u;
  for (uint k = 0u; k < TEXEL_RUN; ++k) lit |= is_lit(at + uvec2(k, 0u)) ? 1u << k : 0u;
  if (lit == 0u) return;

  const uint found = bitCount(lit);
  const uint rank =
      counted ? atomicAdd(lists[io.list].written, found) : atomicAdd(lists[io.list].count, found);
  if (counts_only) return;

  uint place = counted ? lists[io.list].first + rank : rank;
  for (uint k = 0u; k < TEXEL_RUN; ++k) {
    if ((lit & 1u << k) == 0u) continue;
    const uvec2 to = io.origin + uvec2(place % io.side, place / io.side);
    imageStore(entries, ivec2(to), uvec4(at.x + k | at.y << 16));
    ++place;
  }
}
