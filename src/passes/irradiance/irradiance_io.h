// SPDX-License-Identifier: MIT
#ifndef DERMIS_PASSES_IRRADIANCE_IO_H
#define DERMIS_PASSES_IRRADIANCE_IO_H
#include "shared/types.h"
DERMIS_IO_BEGIN
struct IrradianceIo {
  vec3 offset_m;  // of this head
};
DERMIS_IO_END
#endif
