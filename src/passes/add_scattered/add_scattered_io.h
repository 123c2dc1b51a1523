// SPDX-License-Identifier: MIT
#ifndef DERMIS_PASSES_ADD_SCATTERED_IO_H
#define DERMIS_PASSES_ADD_SCATTERED_IO_H
#include "shared/entries_io.h"
DERMIS_IO_BEGIN
struct AddScatteredIo {
  uvec2 low, size;  // pixels that hold all heads
  uint width;       // of the picture, pixels
};
DERMIS_IO_END
#endif
