// SPDX-License-Identifier: MIT
#ifndef DERMIS_PASSES_LABEL_PLANES_IO_H
#define DERMIS_PASSES_LABEL_PLANES_IO_H
#include "render/shared/types.h"
DERMIS_IO_BEGIN
struct LabelPlanesIo {
  uvec2 size;  // of the picture, pixels
};
DERMIS_IO_END
#endif
