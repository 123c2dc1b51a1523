// SPDX-License-Identifier: MIT
#ifndef DERMIS_PASSES_SCATTER_SUM_IO_H
#define DERMIS_PASSES_SCATTER_SUM_IO_H
#include "render/shared/terms.h"
#include "render/shared/types.h"
DERMIS_IO_BEGIN
struct ScatterSumIo {
  vec3 weights[MOST_TERMS];  // of the profile, narrow to wide
  uvec2 origin;              // of the square in the pool, texels
  uint side;                 // T
  uint layer;                // of the sum
};
DERMIS_IO_END
#ifdef __cplusplus
static_assert(sizeof(dermis::io::ScatterSumIo) == 112);
#endif
#endif
