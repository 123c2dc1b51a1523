// SPDX-License-Identifier: MIT
#ifndef DERMIS_PASSES_DEFORM_IO_H
#define DERMIS_PASSES_DEFORM_IO_H
#include "shared/types.h"
DERMIS_IO_BEGIN
struct DeformIo {
  uint count;                                           // of the vertices to write
  uint position_stride, normal_stride, tangent_stride;  // floats; 0: not given
};
// A vertex of a skin mesh and the vertex of its source that it is a copy of.
struct SourceVertexIo {
  uint vertex, source;
};
DERMIS_IO_END
#ifdef __cplusplus
static_assert(sizeof(dermis::io::DeformIo) == 16);
static_assert(sizeof(dermis::io::SourceVertexIo) == 8);
#endif
#endif
