// SPDX-License-Identifier: MIT
// Tiles of light maps, and the lists of those that a frame lights and blurs:
// render/passes/light_map/tile_lists.h.
#ifndef DERMIS_SHARED_TILES_IO_H
#define DERMIS_SHARED_TILES_IO_H
#include "render/shared/types.h"
#define TILE_SIDE 8  // texels of a tile, which one workgroup computes, in either direction
// Workgroups in x of an indirect dispatch: all devices allow 65535 in each direction.
#define TILE_ROW 32768
// Marks of a tile, as bits. Seen: a triangle that a pixel may show touches it. Source: texels of seen
// tiles beside their charts take their light from it; it is lit as seen ones are. Gutter: light of seen
// tiles continues there, beyond a seam; it is blurred as well. Only the first is stored: links tell the
// others.
#define TILE_SEEN 1
#define TILE_SOURCE 2
#define TILE_GUTTER 4
// TileLinks: the first link of each tile of a square, and one past the last, then two words per link. The
// first is a tile; where that is seen, and the second is not, the tile that has the link is lit, or blurred
// without this bit.
#define TILE_LINK_LIGHTS 0x80000000u
#define NO_TILE 0xFFFFFFFFu
// Lists of lit tiles of a square, by material: all materials from the last one on share it.
#define MOST_TILE_LISTS 8
DERMIS_IO_BEGIN
struct TileArgumentsIo {
  uint groups[3];  // VkDispatchIndirectCommand over the tiles of a list
};

// Returns the columns and rows of tiles of a map.
#ifdef __cplusplus
inline
#endif
    uvec2
    tiles_across(uint side) {
  return (uvec2(side) + uint(TILE_SIDE) - 1u) / uint(TILE_SIDE);
}
DERMIS_IO_END
#endif
