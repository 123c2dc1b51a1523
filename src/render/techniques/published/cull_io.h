// SPDX-License-Identifier: MIT
#ifndef DERMIS_PUBLISHED_CULL_IO_H
#define DERMIS_PUBLISHED_CULL_IO_H
#include "render/shared/types.h"
DERMIS_IO_BEGIN
// Decides, with the camera, which triangles are not lit: cull.glsl.
struct CullIo {
  uint can_cull;  // 0: both sides of this material are visible
  float side;     // T, texels
};
struct CullTrianglesIo {
  CullIo cull;
  uint first, count;  // triangles of one material
};
DERMIS_IO_END
#endif
