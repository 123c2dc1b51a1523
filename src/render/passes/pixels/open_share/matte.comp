// SPDX-License-Identifier: MIT
// The share of each pixel that heads cover, as the caller of a session reads it: row by row.
#version 460
#include "render/passes/pixels/open_share/matte_io.h"
layout(local_size_x = 16, local_size_y = 16) in;
layout(push_constant, scalar) uniform Push { MatteIo io; };
layout(binding = 0) uniform sampler2D open;
layout(binding = 1, scalar) writeonly buffer Matte { float matte[]; };

void main() {
  const uvec2 p = gl_GlobalInvocationID.xy;
  if (any(greaterThanEqual(p, io.size))) return;
  matte[p.y * io.size.x + p.x] = 1.0 - texelFetch(open, ivec2(p), 0).r;
}
