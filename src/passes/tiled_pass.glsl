// SPDX-License-Identifier: MIT
// A pass over the whole square of a map, or over the tiles that hold light. Needs `io`, and of the
// pass: own_light(p), the light of a texel before the pass, whose alpha says whether it is lit; and
// spread(p, own), the light after it.
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

  const vec4 own = own_light(p);
  imageStore(light_out, p + ivec2(io.origin), own.a == 0.0 ? vec4(0.0) : spread(p, own));
}
