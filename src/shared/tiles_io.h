// SPDX-License-Identifier: MIT
#ifndef DERMIS_SHARED_TILES_IO_H
#define DERMIS_SHARED_TILES_IO_H
#include "shared/types.h"
// Texels of a tile: what one workgroup of the convolution computes.
#define TILE_WIDTH 16
#define TILE_HEIGHT 8
// Workgroups in x of an indirect dispatch: all devices allow 65535 in each direction.
#define TILE_ROW 32768
// What a tile holds, as bits.
#define TILE_LIT 1
#define TILE_UNLIT 2
DERMIS_IO_BEGIN
struct TileArgumentsIo {
  uint listed_groups[3];  // VkDispatchIndirectCommand
  uint idle_groups[3];    // VkDispatchIndirectCommand
};
struct TileCountsIo {
  uint listed, idle;
};
struct TilesIo {
  uvec2 origin;     // of the square in the pool
  uint side;        // T, texels
  uint square;      // number in the pool
  uint first_tile;  // of the square's in the buffers: listed ones from the front, idle ones from the back
  uint tile_count;  // of the used square
  // 1: list tiles with unlit texels beside lit tiles; 0: list tiles with lit texels, the others are idle
  uint border;
  uint slot;  // of the counters: tiles listed
};
struct IdleIo {
  uvec2 origin;
  uint side;
  uint square;
  uint last_tile;  // in the list; idle tiles are stored backwards from here
};
DERMIS_IO_END
#endif
