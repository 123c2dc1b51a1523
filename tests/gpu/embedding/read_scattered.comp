// SPDX-License-Identifier: MIT
// Reads the scattered light of a head as a host does, at a grid of texture coordinates.
#version 460
#extension GL_GOOGLE_include_directive : require
#define DERMIS_SET 0
#define DERMIS_LIGHT_BINDING 0
#define DERMIS_RECORDS_BINDING 1
#include "dermis/scattered.glsl"
layout(local_size_x = 8, local_size_y = 8) in;
layout(binding = 2, scalar) writeonly buffer Found { DermisScattered found[]; };
layout(push_constant) uniform Push { uint record, side; };

void main() {
  const uvec2 p = gl_GlobalInvocationID.xy;
  if (any(greaterThanEqual(p, uvec2(side)))) return;
  found[p.y * side + p.x] = dermis_scattered(record, (vec2(p) + 0.5) / float(side));
}
