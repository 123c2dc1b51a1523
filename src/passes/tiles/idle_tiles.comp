// SPDX-License-Identifier: MIT
// Clears the tiles that no convolution will write, so that nothing left over is read there.
#version 460
#include "shaders/tile_list.glsl"
layout(local_size_x = TILE_WIDTH, local_size_y = TILE_HEIGHT) in;
layout(push_constant, scalar) uniform Push { IdleIo io; };
layout(binding = 0, scalar) readonly buffer Tiles { uint tiles[]; };
layout(binding = 1, scalar) readonly buffer TileCounts { TileCountsIo tile_counts[]; };
layout(binding = 2, rgba16f) uniform writeonly image2D light;

void main() {
  const uint i = tile_number(gl_WorkGroupID.xy);
  if (i >= tile_counts[io.square].idle) return;
  const ivec2 p = tile_corner(tiles[io.last_tile - i]) + ivec2(gl_LocalInvocationID.xy);
  if (any(greaterThanEqual(p, ivec2(io.side)))) return;
  imageStore(light, p + ivec2(io.origin), vec4(0.0));
}
