// SPDX-License-Identifier: MIT
#ifndef DERMIS_PASSES_MOVE_RIG_IO_H
#define DERMIS_PASSES_MOVE_RIG_IO_H
#include "render/shared/types.h"
DERMIS_IO_BEGIN
struct MoveRigIo {
  uint first, count;  // vertices
  float mm_per_unit;  // of the metric
};
DERMIS_IO_END
#ifdef __cplusplus
static_assert(sizeof(dermis::io::MoveRigIo) == 12);
#endif
#endif
