// SPDX-License-Identifier: MIT
// Gives each part its range of the list of a band, in the order of the parts, and its indirect dispatch. One
// workgroup.
#version 460
#include "render/passes/pixels/entries/entries_io.h"
layout(local_size_x = 64) in;
layout(push_constant, scalar) uniform Push { PartRangesIo io; };
layout(binding = 0, scalar) buffer Parts { PartIo parts[]; };
layout(binding = 1, scalar) writeonly buffer List { PartRangeIo ranges[]; };
shared uint sums[64];

void main() {
  const uint each = (io.parts + 63u) / 64u, from = min(gl_LocalInvocationIndex * each, io.parts),
             to = min(from + each, io.parts);
  uint sum = 0u;
  for (uint i = from; i < to; ++i) sum += parts[io.first_part + i].count;
  sums[gl_LocalInvocationIndex] = sum;
  barrier();

  uint first = 2u * io.parts;  // words of the ranges themselves
  for (uint k = 0u; k < gl_LocalInvocationIndex; ++k) first += sums[k];
  for (uint i = from; i < to; ++i) {
    const uint part = io.first_part + i, count = parts[part].count,
               groups = (count + ENTRY_GROUP - 1u) / ENTRY_GROUP;
    ranges[i] = PartRangeIo(first, count);
    parts[part].groups[0] = min(groups, ENTRY_ROW);
    parts[part].groups[1] = (groups + ENTRY_ROW - 1u) / ENTRY_ROW;
    parts[part].groups[2] = 1u;
    first += count;
  }
}
