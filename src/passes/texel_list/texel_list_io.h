// SPDX-License-Identifier: MIT
#ifndef DERMIS_PASSES_TEXEL_LIST_IO_H
#define DERMIS_PASSES_TEXEL_LIST_IO_H
#include "shared/types.h"
DERMIS_IO_BEGIN
// The texels of one material in a square of the light maps.
struct ListTexelsIo {
  uvec2 origin;                       // of the square in the pool
  uint side;                          // T, texels
  uint first_triangle, end_triangle;  // of the material
  uint list;                          // its number
};
// The lists of one square.
struct TexelRangesIo {
  uint first_list, materials;
};
DERMIS_IO_END
// Texels in x that one invocation looks at.
#define TEXEL_RUN 8
#ifdef __cplusplus
static_assert(sizeof(dermis::io::ListTexelsIo) == 24);
static_assert(sizeof(dermis::io::TexelRangesIo) == 8);
#endif
#endif
