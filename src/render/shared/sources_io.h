// SPDX-License-Identifier: MIT
#ifndef DERMIS_SHARED_SOURCES_IO_H
#define DERMIS_SHARED_SOURCES_IO_H
#include "render/shared/types.h"

DERMIS_IO_BEGIN

// A vertex of a skin mesh, and the vertex of the asset's source that it came from.
struct SourceVertexIo {
  uint vertex;  // of the skin mesh
  uint source;  // in the arrays or accessors of its mesh
};

DERMIS_IO_END

#ifdef __cplusplus
static_assert(sizeof(dermis::io::SourceVertexIo) == 2 * 4);
#endif
#endif
