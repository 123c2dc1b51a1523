// SPDX-License-Identifier: MIT
#ifndef DERMIS_PASSES_CULL_TRIANGLES_IO_H
#define DERMIS_PASSES_CULL_TRIANGLES_IO_H
#include "shared/cull_io.h"
#include "shared/types.h"
DERMIS_IO_BEGIN
struct CullTrianglesIo {
  CullIo cull;
  uint first, count;  // triangles of one material
};
DERMIS_IO_END
#ifdef __cplusplus
static_assert(sizeof(dermis::io::CullTrianglesIo) == 16);
#endif
#endif
