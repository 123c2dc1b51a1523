// SPDX-License-Identifier: MIT
// Packs tiles for a list, and finds the entry of a workgroup of an indirect dispatch.
#include "render/shared/tiles_io.h"
uvec2 tiles_across(uint side) {
  return (uvec2(side) + uvec2(TILE_WIDTH, TILE_HEIGHT) - 1u) / uvec2(TILE_WIDTH, TILE_HEIGHT);
}
uint tile_of(uvec2 texel, uint side) {
  return texel.y / TILE_HEIGHT * tiles_across(side).x + texel.x / TILE_WIDTH;
}
uint tile_material(uint list) { return 8u << list; }  // a mark: it holds texels of such a material
uint tile_entry(uvec2 tile) { return tile.x | tile.y << 16; }
ivec2 tile_corner(uint entry) { return ivec2(entry & 0xFFFFu, entry >> 16) * ivec2(TILE_WIDTH, TILE_HEIGHT); }
uint tile_number(uvec2 workgroup) { return workgroup.y * TILE_ROW + workgroup.x; }
