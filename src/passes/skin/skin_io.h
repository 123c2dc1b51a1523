// SPDX-License-Identifier: MIT
#ifndef DERMIS_PASSES_SKIN_IO_H
#define DERMIS_PASSES_SKIN_IO_H
#include "shared/types.h"
DERMIS_IO_BEGIN
struct SkinIo {
  vec3 offset_m;     // of this head
  vec3 weights[8];   // of the profile, narrow to wide; a channel sums to 1
  uvec2 map_origin;  // of the head's square in the pool of light maps
  uint map_side;     // T, texels
  uint slot;         // of the counters, see skin_reads.frag
  uint halvings;     // four bits a term: the side of its map is T >> n
};
DERMIS_IO_END
#ifdef __cplusplus
static_assert(sizeof(dermis::io::SkinIo) == 128);
#endif
#endif
