// SPDX-License-Identifier: MIT
#ifndef DERMIS_PASSES_DILATE_IO_H
#define DERMIS_PASSES_DILATE_IO_H
#include "shared/types.h"
DERMIS_IO_BEGIN
struct DilateIo {
  uvec2 origin;     // of the square in the pool
  uint side;        // T, texels
  uint square;      // number in the pool
  uint first_tile;  // of the square's in the list
};
DERMIS_IO_END
#endif
