// SPDX-License-Identifier: MIT
// Packs tiles for a list, and finds the entry of a workgroup of an indirect dispatch.
#include "render/shared/tiles_io.h"
uint tile_material(uint list) { return 8u << list; }  // a mark: it holds texels of such a material
uint tile_entry(uvec2 tile) { return tile.x | tile.y << 16; }
ivec2 tile_corner(uint entry) { return ivec2(entry & 0xFFFFu, entry >> 16) * TILE_SIDE; }
uint tile_number(uvec2 workgroup) { return workgroup.y * TILE_ROW + workgroup.x; }
