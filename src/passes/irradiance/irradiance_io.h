// SPDX-License-Identifier: MIT
#ifndef DERMIS_PASSES_IRRADIANCE_IO_H
#define DERMIS_PASSES_IRRADIANCE_IO_H
#include "shared/types.h"
DERMIS_IO_BEGIN
struct IrradianceIo {
  vec3 offset_m;  // of this head
  uint can_cull;  // 0: both sides of this material are seen
  vec4 eye;       // position, w = 1; orthographic: direction towards it, w = 0
  vec4 planes[5];
};
DERMIS_IO_END
#ifdef __cplusplus
static_assert(sizeof(dermis::io::IrradianceIo) == 112);
#endif
#endif
