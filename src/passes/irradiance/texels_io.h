// SPDX-License-Identifier: MIT
#ifndef DERMIS_PASSES_TEXELS_IO_H
#define DERMIS_PASSES_TEXELS_IO_H
#include "shared/types.h"
DERMIS_IO_BEGIN
// A square of light maps, and the list of the texels of one material in it.
struct TexelsIo {
  uvec2 origin;  // of the square in the pool
  uint side;     // T, texels
  uint list;     // its number: passes/texel_lists.h
};
DERMIS_IO_END
#ifdef __cplusplus
static_assert(sizeof(dermis::io::TexelsIo) == 16);
#endif
#endif
