// SPDX-License-Identifier: MIT
#ifndef DERMIS_PASSES_FRONT_PLANES_IO_H
#define DERMIS_PASSES_FRONT_PLANES_IO_H
#include "render/shared/types.h"
DERMIS_IO_BEGIN
struct FrontPlanesIo {
  uvec2 size;           // of the picture, pixels
  uint first_coverage;  // words before the planes
  uint first_part;
};
DERMIS_IO_END
#endif
