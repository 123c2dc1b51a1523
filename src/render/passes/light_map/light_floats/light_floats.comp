// SPDX-License-Identifier: MIT
// The linear picture as the caller of a session reads it: 32-bit floats, row by row.
#version 460
#include "render/passes/light_map/light_floats/light_floats_io.h"
layout(local_size_x = 16, local_size_y = 16) in;
layout(push_constant, scalar) uniform Push { LightFloatsIo io; };
layout(binding = 0) uniform sampler2D picture;
layout(binding = 1, scalar) writeonly buffer Floats { vec4 floats[]; };

void main() {
  const uvec2 p = gl_GlobalInvocationID.xy;
  if (any(greaterThanEqual(p, io.size))) return;
  floats[p.y * io.size.x + p.x] = texelFetch(picture, ivec2(p), 0);
}
