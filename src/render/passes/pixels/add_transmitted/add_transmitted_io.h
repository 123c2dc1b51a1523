// SPDX-License-Identifier: MIT
#ifndef DERMIS_PASSES_ADD_TRANSMITTED_IO_H
#define DERMIS_PASSES_ADD_TRANSMITTED_IO_H
#include "render/shared/types.h"
DERMIS_IO_BEGIN
struct AddTransmittedIo {
  uvec2 origin;  // of the square in the pool
  uint side;     // T, texels
};
DERMIS_IO_END
#endif
