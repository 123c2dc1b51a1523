// SPDX-License-Identifier: MIT
#ifndef DERMIS_PASSES_TILES_IO_H
#define DERMIS_PASSES_TILES_IO_H
#include "render/shared/types.h"
DERMIS_IO_BEGIN
// Triangles of one material in a square of the light maps.
struct SeenTilesIo {
  uint can_cull;      // 0: both sides of this material are visible
  uint first, count;  // of the triangles
  uint side;          // T, texels
  uint first_tile;    // of the square's marks
  uint list;          // of the material, among those of the square
  float reach;        // texels beside the triangle that reads of its points touch
};
struct TilesIo {
  uint side;
  uint first_tile;
  uint first_list, lists;  // of the square
  uint room;               // entries of a list
  uint slot;               // of the counters: tiles to blur
  uint linked;             // 1: there are TileLinks
};
struct ClearTilesIo {
  uvec2 origin;  // of the square in the pool, texels
  uint side;
};
DERMIS_IO_END
#ifdef __cplusplus
static_assert(sizeof(dermis::io::SeenTilesIo) == 28);
#endif
#endif
