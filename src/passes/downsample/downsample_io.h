// SPDX-License-Identifier: MIT
#ifndef DERMIS_PASSES_DOWNSAMPLE_IO_H
#define DERMIS_PASSES_DOWNSAMPLE_IO_H
#include "shared/types.h"
DERMIS_IO_BEGIN
struct DownsampleIo {
  uvec2 origin;  // of the square in the smaller pool
  uint side;     // of its used part there, texels
  uint ratio;    // texels of the larger map along a side of one texel: 1, 2
  uvec2 from;    // origin of the square in the larger pool
};
DERMIS_IO_END
#endif
