// SPDX-License-Identifier: MIT
// Lists the tiles of a square by their marks. Their order differs from run to run; the results do not.
#version 460
#include "render/passes/light_map/tiles/tiles_io.h"
#include "render/shaders/tile_list.glsl"
layout(local_size_x = 8, local_size_y = 8) in;
layout(push_constant, scalar) uniform Push { TilesIo io; };
layout(binding = 0, scalar) readonly buffer TileMarks { uint tile_marks[]; };
layout(binding = 1, scalar) writeonly buffer Tiles { uint tiles[]; };
layout(binding = 2, scalar) buffer TileArguments { TileArgumentsIo tile_arguments[]; };
layout(binding = 3, scalar) buffer TileCounts { uint tile_counts[]; };
layout(binding = 4, scalar) buffer Counters { uint counters[]; };

void add_to(uint list, uvec2 tile) {
  const uint i = atomicAdd(tile_counts[list], 1u);
  tiles[list * io.room + i] = tile_entry(tile);
  atomicMax(tile_arguments[list].groups[0], min(i + 1u, TILE_ROW));
  atomicMax(tile_arguments[list].groups[1], i / TILE_ROW + 1u);
  atomicMax(tile_arguments[list].groups[2], 1u);
}

void main() {
  const uvec2 tile = gl_GlobalInvocationID.xy, across = tiles_across(io.side);
  if (any(greaterThanEqual(tile, across))) return;

  const uint marks = tile_marks[io.first_tile + tile.y * across.x + tile.x];
  const uint blurred = io.lists - 1u;
  for (uint i = 0u; i < blurred; ++i)
    if ((marks & (TILE_SEEN | TILE_SOURCE)) != 0u && (marks & tile_material(i)) != 0u)
      add_to(io.first_list + i, tile);

  if ((marks & (TILE_SEEN | TILE_SOURCE | TILE_GUTTER)) == 0u) return;
  add_to(io.first_list + blurred, tile);
  atomicAdd(counters[io.slot], 1u);
}
