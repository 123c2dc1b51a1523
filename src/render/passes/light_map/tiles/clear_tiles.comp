// SPDX-License-Identifier: MIT
// Empties a square of a map.
#version 460
#include "render/passes/light_map/tiles/tiles_io.h"
layout(local_size_x = 16, local_size_y = 8) in;
layout(push_constant, scalar) uniform Push { ClearTilesIo io; };
layout(binding = 0, rgba16f) uniform writeonly image2D light;

void main() {
  const uvec2 at = gl_GlobalInvocationID.xy;
  if (all(lessThan(at, uvec2(io.side)))) imageStore(light, ivec2(io.origin + at), vec4(0.0));
}
