// SPDX-License-Identifier: MIT
#ifndef DERMIS_PASSES_BLOOM_IO_H
#define DERMIS_PASSES_BLOOM_IO_H
#include "render/shared/types.h"
DERMIS_IO_BEGIN

// The steps, BloomIo::mode.
#define BLOOM_DOWNSAMPLE 0u
#define BLOOM_BLUR_X 1u
#define BLOOM_BLUR_Y 2u

struct BloomIo {
  uint mode;      // BLOOM_...
  float sigma;    // to blur: pixels of the picture that is blurred
  uint halvings;  // to downsample: from the picture to the target
};
DERMIS_IO_END
#endif
