// SPDX-License-Identifier: MIT
// Gives each list of a square its place among the entries, in the order of the materials, and its indirect
// dispatch.
#version 460
#include "passes/texel_list/texel_list_io.h"
#include "shared/texel_lists_io.h"
layout(local_size_x = 1) in;
layout(push_constant, scalar) uniform Push { TexelRangesIo io; };
layout(binding = 0, scalar) buffer Lists { TexelListIo lists[]; };
layout(binding = 1, scalar) writeonly buffer Arguments { TexelArgumentsIo arguments[]; };

void main() {
  uint first = 0u;
  for (uint i = io.first_list; i < io.first_list + io.materials; ++i) {
    const uint groups = (lists[i].count + TEXEL_GROUP - 1u) / TEXEL_GROUP;
    arguments[i].groups[0] = min(groups, TEXEL_ROW);
    arguments[i].groups[1] = (groups + TEXEL_ROW - 1u) / TEXEL_ROW;
    arguments[i].groups[2] = 1u;
    lists[i].first = first;
    first += lists[i].count;
  }
}
