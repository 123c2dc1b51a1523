// SPDX-License-Identifier: MIT
// Lists tiles by what they hold. Their order differs from run to run; the results do not.
#version 460
#include "shaders/tile_list.glsl"
layout(local_size_x = 8, local_size_y = 8) in;
layout(push_constant, scalar) uniform Push { TilesIo io; };
layout(binding = 0, scalar) readonly buffer TileClasses { uint tile_classes[]; };
layout(binding = 1, scalar) writeonly buffer Tiles { uint tiles[]; };
layout(binding = 2, scalar) buffer TileArguments { TileArgumentsIo tile_arguments[]; };
layout(binding = 3, scalar) buffer TileCounts { TileCountsIo tile_counts[]; };
layout(binding = 4, scalar) buffer Counters { uint counters[]; };

uint holds(ivec2 tile, ivec2 across) {
  if (any(lessThan(tile, ivec2(0))) || any(greaterThanEqual(tile, across))) return 0u;
  return tile_classes[io.first_tile + tile.y * across.x + tile.x];
}

void main() {
  const ivec2 tile = ivec2(gl_GlobalInvocationID.xy), across = ivec2(tiles_across(io.side));
  if (any(greaterThanEqual(tile, across))) return;

  const uint own = holds(tile, across);
  uint around = own;
  if (io.border != 0u)
    for (int y = -1; y <= 1; ++y)
      for (int x = -1; x <= 1; ++x) around |= holds(tile + ivec2(x, y), across);

  const bool listed =
      io.border != 0u ? (own & TILE_UNLIT) != 0u && (around & TILE_LIT) != 0u : (own & TILE_LIT) != 0u;
  const uint entry = tile_entry(uvec2(tile));

  if (listed) {
    const uint i = atomicAdd(tile_counts[io.square].listed, 1u);
    tiles[io.first_tile + i] = entry;
    atomicMax(tile_arguments[io.square].listed_groups[0], min(i + 1u, TILE_ROW));
    atomicMax(tile_arguments[io.square].listed_groups[1], i / TILE_ROW + 1u);
    atomicMax(tile_arguments[io.square].listed_groups[2], 1u);
    if (io.border == 0u) atomicAdd(counters[io.slot], 1u);
  } else {
    // Idle tiles fill the list from its end.
    const uint i = atomicAdd(tile_counts[io.square].idle, 1u);
    tiles[io.first_tile + io.tile_count - 1u - i] = entry;
    atomicMax(tile_arguments[io.square].idle_groups[0], min(i + 1u, TILE_ROW));
    atomicMax(tile_arguments[io.square].idle_groups[1], i / TILE_ROW + 1u);
    atomicMax(tile_arguments[io.square].idle_groups[2], 1u);
  }
}
