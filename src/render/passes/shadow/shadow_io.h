// SPDX-License-Identifier: MIT
#ifndef DERMIS_PASSES_SHADOW_IO_H
#define DERMIS_PASSES_SHADOW_IO_H
#include "render/shared/types.h"
DERMIS_IO_BEGIN
struct ShadowIo {
  mat4 shadow_from_world;
  float grow;      // one texel of this map, in width and height of the clip volume; see shadow.vert
  uint is_turned;  // the map shows what the light sees, and no mirror image: front faces wind the other way
};
// See shadow_of_host.frag.
struct HostShadowIo {
  float texel;    // 1 / side of the map
  uint reversed;  // the host's depth is: near is 1
};
DERMIS_IO_END
#endif
