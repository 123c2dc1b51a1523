// SPDX-License-Identifier: MIT
#ifndef DERMIS_PASSES_UPSAMPLE_IO_H
#define DERMIS_PASSES_UPSAMPLE_IO_H
#include "passes/cascade_level_io.h"
#include "shared/types.h"
DERMIS_IO_BEGIN
struct UpsampleIo {
  uvec2 origin;          // of the square in the larger pool
  uint side;             // of its used part there, texels
  uint ratio;            // texels of the larger map along a side of one of the smaller: 1, 2
  uvec2 from;            // origin of the square in the smaller pool
  vec3 joins;            // weight of the light that joins
  vec3 spread;           // of what has spread: the sum of the weights of its terms
  CascadeLevelIo level;  // from which the light comes; without terms all of it is taken
};
DERMIS_IO_END
#endif
