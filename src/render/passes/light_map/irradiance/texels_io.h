// SPDX-License-Identifier: MIT
#ifndef DERMIS_PASSES_TEXELS_IO_H
#define DERMIS_PASSES_TEXELS_IO_H
#include "render/shared/types.h"
DERMIS_IO_BEGIN
// The lit texels of one material in a square of light maps.
struct TexelsIo {
  uvec2 origin;  // of the square in the pool
  uint side;     // T, texels
  uint list;     // of the tiles that hold such texels: render/passes/light_map/tile_lists.h
  uint room;     // entries of a list
  uint first_triangle, end_triangle;  // of the material
};
DERMIS_IO_END
#ifdef __cplusplus
static_assert(sizeof(dermis::io::TexelsIo) == 28);
#endif
#endif
