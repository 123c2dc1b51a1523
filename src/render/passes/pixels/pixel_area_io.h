// SPDX-License-Identifier: MIT
#ifndef DERMIS_PASSES_PIXEL_AREA_IO_H
#define DERMIS_PASSES_PIXEL_AREA_IO_H
#include "render/shared/types.h"
DERMIS_IO_BEGIN
// A rectangle of pixels; an invocation for each.
struct PixelAreaIo {
  uvec2 low, size;
};
DERMIS_IO_END
#endif
