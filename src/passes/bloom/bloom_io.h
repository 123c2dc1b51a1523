// SPDX-License-Identifier: MIT
#ifndef DERMIS_PASSES_BLOOM_IO_H
#define DERMIS_PASSES_BLOOM_IO_H
#include "shared/types.h"
DERMIS_IO_BEGIN
struct BloomIo {
  uint mode;                         // 0: halve, 1: blur along x, 2: blur along y, 3: combine
  float sigma;                       // pixels of the half-size picture
  float weight_narrow, weight_wide;  // of the two Gaussians, together 1; mode 3
  float amount;                      // 0..1, share of the light that is spread; mode 3
};
DERMIS_IO_END
#endif
