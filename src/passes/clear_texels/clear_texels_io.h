// SPDX-License-Identifier: MIT
#ifndef DERMIS_PASSES_CLEAR_TEXELS_IO_H
#define DERMIS_PASSES_CLEAR_TEXELS_IO_H
#include "shared/types.h"
DERMIS_IO_BEGIN
struct ClearTexelsIo {
  uvec2 origin;  // of the square in the pool, texels
  uint side;     // T
};
DERMIS_IO_END
#endif
