// SPDX-License-Identifier: MIT
#ifndef DERMIS_PASSES_SURFACE_IO_H
#define DERMIS_PASSES_SURFACE_IO_H
#include "shared/types.h"
DERMIS_IO_BEGIN
struct SurfaceIo {
  vec3 offset_m;  // of this head
};
DERMIS_IO_END
#endif
