// SPDX-License-Identifier: MIT
// In compute, over the whole square or over the tiles that hold light.
#version 460
#include "passes/cascade/cascade_sum.glsl"
#include "shaders/tile_list.glsl"
layout(constant_id = 0) const bool tiled = false;
layout(local_size_x = TILE_WIDTH, local_size_y = TILE_HEIGHT) in;
layout(binding = 3, rgba16f) uniform writeonly image2D light_out;
layout(binding = 4, scalar) readonly buffer Tiles { uint tiles[]; };
layout(binding = 5, scalar) readonly buffer TileCounts { TileCountsIo tile_counts[]; };

void main() {
  ivec2 p = ivec2(gl_GlobalInvocationID.xy);
  if (tiled) {
    const uint i = tile_number(gl_WorkGroupID.xy);
    if (i >= tile_counts[io.square].listed) return;
    p = tile_corner(tiles[io.first_tile + i]) + ivec2(gl_LocalInvocationID.xy);
  }
  if (any(greaterThanEqual(p, ivec2(io.side)))) return;
  const vec4 centre = texelFetch(unspread, p + ivec2(io.origin), 0);
  imageStore(light_out, p + ivec2(io.origin), centre.a == 0.0 ? vec4(0.0) : computed(p, centre));
}
