// SPDX-License-Identifier: MIT
// Finds what each tile of a square holds. One invocation per tile: barriers cost software devices more than
// this loop.
#version 460
#include "shaders/tile_list.glsl"
layout(local_size_x = 8, local_size_y = 8) in;
layout(push_constant, scalar) uniform Push { TilesIo io; };
layout(binding = 0, rgba16f) uniform readonly image2D light;
layout(binding = 1, scalar) writeonly buffer TileClasses { uint tile_classes[]; };

void main() {
  const uvec2 tile = gl_GlobalInvocationID.xy, tiles = tiles_across(io.side);
  if (any(greaterThanEqual(tile, tiles))) return;
  const ivec2 corner = ivec2(tile) * ivec2(TILE_WIDTH, TILE_HEIGHT);
  uint holds = 0u;
  for (int y = 0; y < TILE_HEIGHT; ++y)
    for (int x = 0; x < TILE_WIDTH; ++x) {
      const ivec2 p = min(corner + ivec2(x, y), ivec2(io.side) - 1);
      holds |= imageLoad(light, p + ivec2(io.origin)).a != 0.0 ? TILE_LIT : TILE_UNLIT;
    }
  tile_classes[io.first_tile + tile.y * tiles.x + tile.x] = holds;
}
