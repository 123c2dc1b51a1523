// SPDX-License-Identifier: MIT
#ifndef DERMIS_PASSES_COUNT_IO_H
#define DERMIS_PASSES_COUNT_IO_H
#include "render/shared/types.h"
DERMIS_IO_BEGIN
struct CountIo {
  uvec2 origin, extent;
  uint slot;        // of the counters
  float threshold;  // counted if alpha is at least this
};
DERMIS_IO_END
#endif
