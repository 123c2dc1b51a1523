// SPDX-License-Identifier: MIT
#ifndef DERMIS_PUBLISHED_BLUR_IO_H
#define DERMIS_PUBLISHED_BLUR_IO_H
#include "render/shared/types.h"
// Kernels as kernels.h tabulates them.
#define PAPER_TAPS 6         // -6 .. 6
#define PAPER_MAX_SIGMA 2.0  // in units of the tap spacing: three sigma on either side
#define PAPER_ROWS 129       // sigma = 0 .. PAPER_MAX_SIGMA
#define PAPER_ROW_FLOATS 8   // whole texels: weights of taps 0, +-1, .. +-6, and one that is not used
DERMIS_IO_BEGIN
struct PaperBlurIo {
  float variance_mm2;   // of this step
  uint axis;            // 0, then 1
  uint texel_averaged;  // the first step: its input is constant over each texel
  uint side;            // T, texels
};
DERMIS_IO_END
#endif
