// SPDX-License-Identifier: MIT
// Lists the tiles of a square by their marks, and those beyond seams of seen ones. Their order differs from
// run to run; the results do not.
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
layout(binding = 5, scalar) readonly buffer TileLinks { uint tile_links[]; };

void add_to(uint list, uvec2 tile) {
  const uint i = atomicAdd(tile_counts[list], 1u);
  tiles[list * io.room + i] = tile_entry(tile);
  atomicMax(tile_arguments[list].groups[0], min(i + 1u, TILE_ROW));
  atomicMax(tile_arguments[list].groups[1], i / TILE_ROW + 1u);
  atomicMax(tile_arguments[list].groups[2], 1u);
}

bool is_seen(uint tile) { return tile != NO_TILE && (tile_marks[io.first_tile + tile] & TILE_SEEN) != 0u; }

// Returns the marks that a tile has from seen ones beyond its seams: those in which its light continues, and
// those whose gutters have nothing of their own chart to repeat.
uint linked_marks(uint tile, uint tiles) {
  uint marks = 0u;
  for (uint i = tile_links[tile]; i < tile_links[tile + 1u]; ++i) {
    const uint at = tiles + 1u + 2u * i, seen = tile_links[at];
    const bool lights = (seen & TILE_LINK_LIGHTS) != 0u;
    if (is_seen(seen & ~TILE_LINK_LIGHTS) && !is_seen(tile_links[at + 1u]))
      marks |= lights ? uint(TILE_SOURCE) : uint(TILE_GUTTER);
  }
  return marks;
}

void main() {
  const uvec2 at = gl_GlobalInvocationID.xy, across = tiles_across(io.side);
  if (any(greaterThanEqual(at, across))) return;

  const uint tile = at.y * across.x + at.x;
  uint marks = tile_marks[io.first_tile + tile];
  if ((marks & TILE_SEEN) == 0u && io.linked != 0u) marks |= linked_marks(tile, across.x * across.y);
  const uint blurred = io.lists - 1u;
  for (uint i = 0u; i < blurred; ++i)
    if ((marks & (TILE_SEEN | TILE_SOURCE)) != 0u && (marks & tile_material(i)) != 0u)
      add_to(io.first_list + i, at);

  if ((marks & (TILE_SEEN | TILE_SOURCE | TILE_GUTTER)) == 0u) return;
  add_to(io.first_list + blurred, at);
  atomicAdd(counters[io.slot], 1u);
}
