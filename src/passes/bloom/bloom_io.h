// SPDX-License-Identifier: MIT
#ifndef DERMIS_PASSES_BLOOM_IO_H
#define DERMIS_PASSES_BLOOM_IO_H
#include "shared/types.h"
DERMIS_IO_BEGIN

// The steps, BloomIo::mode. To combine is to leave the picture as it is and mix in the smaller one.
#define BLOOM_DOWNSAMPLE 0u
#define BLOOM_BLUR_X 1u
#define BLOOM_BLUR_Y 2u
#define BLOOM_COMBINE 3u

struct BloomIo {
  uint mode;      // BLOOM_...
  float sigma;    // to blur: pixels of the picture that is blurred
  float share;    // of the smaller picture in the result, 0..1
  uint halvings;  // from the result to the smaller picture
};
DERMIS_IO_END
#endif
