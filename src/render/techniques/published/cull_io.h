// SPDX-License-Identifier: MIT
#ifndef DERMIS_PUBLISHED_CULL_IO_H
#define DERMIS_PUBLISHED_CULL_IO_H
#include "render/shared/cull_io.h"
#include "render/shared/types.h"
DERMIS_IO_BEGIN
struct CullTrianglesIo {
  CullIo cull;
  uint first, count;  // triangles of one material
};
DERMIS_IO_END
#endif
