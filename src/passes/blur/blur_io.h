// SPDX-License-Identifier: MIT
#ifndef DERMIS_PASSES_BLUR_IO_H
#define DERMIS_PASSES_BLUR_IO_H
#include "shared/types.h"
DERMIS_IO_BEGIN
struct BlurIo {
  float variance_mm2;   // of this step
  uint axis;            // 0: along the first column of the Cholesky factor, 1: along v
  uint texel_averaged;  // 1: input is constant over each texel (the first step)
  uvec2 extent;         // texels used
};
DERMIS_IO_END
#ifdef __cplusplus
static_assert(sizeof(dermis::io::BlurIo) == 20);
#endif
#endif
