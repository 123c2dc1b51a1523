// SPDX-License-Identifier: MIT
#ifndef DERMIS_TESTS_PAINT_IO_H
#define DERMIS_TESTS_PAINT_IO_H
#include "render/shared/types.h"
DERMIS_IO_BEGIN
struct PaintIo {
  uint band;         // 0: an edge; else 1 + P_band(axis . direction) / 2
  vec2 edge_point;   // texels
  vec2 edge_normal;  // towards the lit side
  vec3 axis;
};
DERMIS_IO_END
#endif
