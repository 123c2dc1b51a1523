// SPDX-License-Identifier: MIT
#ifndef DERMIS_SHARED_CULL_IO_H
#define DERMIS_SHARED_CULL_IO_H
#include "render/shared/types.h"
DERMIS_IO_BEGIN
// Decides, with the camera, which triangles of a head its light maps leave out: see render/shaders/cull.glsl.
struct CullIo {
  uint can_cull;   // 0: both sides of this material are visible
  float map_side;  // T, texels, for technique `published`
};
DERMIS_IO_END
#ifdef __cplusplus
static_assert(sizeof(dermis::io::CullIo) == 8);
#endif
#endif
