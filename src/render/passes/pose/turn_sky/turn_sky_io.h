// SPDX-License-Identifier: MIT
#ifndef DERMIS_PASSES_TURN_SKY_IO_H
#define DERMIS_PASSES_TURN_SKY_IO_H
#include "render/shared/types.h"
DERMIS_IO_BEGIN
struct TurnSkyIo {
  uint first, count;  // vertices; texels
};
DERMIS_IO_END
#ifdef __cplusplus
static_assert(sizeof(dermis::io::TurnSkyIo) == 8);
#endif
#endif
