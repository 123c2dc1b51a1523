// SPDX-License-Identifier: MIT
#ifndef DERMIS_SHARED_GUTTERS_IO_H
#define DERMIS_SHARED_GUTTERS_IO_H
#include "render/shared/types.h"
// Alpha of texels beside an open border: no chart, light for bilinear reads only.
#define BORDER_ALPHA 4096.0
// Invocations in x of a dispatch over gutters: all devices allow 65535 workgroups of 64.
#define GUTTER_ROW 2097152
DERMIS_IO_BEGIN
// A texel beside a chart, and the source of its light.
struct GutterIo {
  uint texel;   // x | y << 16
  uint own;     // the nearest texel of the chart it extends: x | y << 16
  vec2 source;  // texels, centres at + 0.5
  uint chart;   // 0: an open border, light for bilinear reads only
};
struct GuttersIo {
  uint count;
  uint mode;     // 0: light from the source; 1: stretch from the own chart
  uvec2 origin;  // of the square in the pool
  uint side;     // T, texels
};
DERMIS_IO_END
#endif
