// SPDX-License-Identifier: MIT
#ifndef DERMIS_PASSES_BLOOM_IO_H
#define DERMIS_PASSES_BLOOM_IO_H
#include "render/shared/types.h"
DERMIS_IO_BEGIN

// Pixels that a workgroup blurs, and rows that it takes at once.
#define BLOOM_WIDTH 16
#define BLOOM_HEIGHT 64
#define BLOOM_ROWS_AT_ONCE 8
// Three sigma of the widest Gaussian: add_bloom() halves the picture until it is narrower.
#define BLOOM_MOST_REACH 16

struct BloomIo {
  float sigma;    // to blur: pixels of the picture that is blurred
  uint halvings;  // to downsample: from the picture to the target
};
DERMIS_IO_END
#endif
