// SPDX-License-Identifier: MIT
#ifndef DERMIS_PASSES_SHADOW_IO_H
#define DERMIS_PASSES_SHADOW_IO_H
#include "shared/types.h"
DERMIS_IO_BEGIN
struct ShadowIo {
  mat4 shadow_from_world;
  vec3 offset_m;  // of this head
};
DERMIS_IO_END
#endif
