// SPDX-License-Identifier: MIT
#ifndef DERMIS_PASSES_CASCADE_LEVEL_IO_H
#define DERMIS_PASSES_CASCADE_LEVEL_IO_H
#include "shared/types.h"
#define MOST_LEVEL_TERMS 4  // wider ones on the same level count with the last
DERMIS_IO_BEGIN
// The terms that a head blurs on one level of a cascade.
struct CascadeLevelIo {
  float moved_texels2;  // what moving light there and back adds along u and v, texels of this map
  float before_mm2;     // variance of what follows on larger maps
  uint terms;
  float steps_mm2[MOST_LEVEL_TERMS];  // of a term, beyond the next narrower one
  float weights[MOST_LEVEL_TERMS];    // mean of the channels
};
DERMIS_IO_END
#ifdef __cplusplus
static_assert(sizeof(dermis::io::CascadeLevelIo) == 44);
#endif
#endif
