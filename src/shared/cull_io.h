// SPDX-License-Identifier: MIT
#ifndef DERMIS_SHARED_CULL_IO_H
#define DERMIS_SHARED_CULL_IO_H
#include "shared/types.h"
DERMIS_IO_BEGIN
// What decides which triangles of a head its light maps leave out: see shaders/cull.glsl for those that face
// away; planes clip the others.
struct CullIo {
  vec3 offset_m;   // of this head
  uint can_cull;   // 0: both sides of this material are visible
  vec4 eye;        // position, w = 1; orthographic: direction towards it, w = 0
  vec4 planes[5];  // dot(xyz, position) + w < 0 is outside
  float map_side;  // of its light maps, texels
};
DERMIS_IO_END
#ifdef __cplusplus
static_assert(sizeof(dermis::io::CullIo) == 116);
#endif
#endif
