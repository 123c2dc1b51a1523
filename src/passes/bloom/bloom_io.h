// SPDX-License-Identifier: MIT
#ifndef DERMIS_PASSES_BLOOM_IO_H
#define DERMIS_PASSES_BLOOM_IO_H
#include "shared/types.h"
DERMIS_IO_BEGIN

// The steps, BloomIo::mode.
#define BLOOM_DOWNSAMPLE 0u
#define BLOOM_BLUR_X 1u
#define BLOOM_BLUR_Y 2u
#define BLOOM_COMBINE 3u

struct BloomIo {
  uint mode;                         // BLOOM_...
  float sigma;                       // to blur: pixels of the half-size picture
  float weight_narrow, weight_wide;  // to combine: of the two Gaussians, together 1
  float amount;                      // to combine: 0..1, share of the light that is spread
};
DERMIS_IO_END
#endif
