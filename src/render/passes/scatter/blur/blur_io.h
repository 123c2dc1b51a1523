// SPDX-License-Identifier: MIT
#ifndef DERMIS_PASSES_BLUR_IO_H
#define DERMIS_PASSES_BLUR_IO_H
#include "render/shared/types.h"
DERMIS_IO_BEGIN
struct BlurIo {
  float variance_mm2;
  float narrower_mm2;   // of the other term of the pass, if it has two
  uint axis;            // 0, then 1
  uint texel_averaged;  // the first step: its input is constant over each texel
  uvec2 origin;         // of the square in the pool
  uint side;            // T, texels
  uint list;            // of its tiles to blur
  uint room;            // entries of a list
};
DERMIS_IO_END
#endif
