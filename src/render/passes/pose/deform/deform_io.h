// SPDX-License-Identifier: MIT
#ifndef DERMIS_PASSES_DEFORM_IO_H
#define DERMIS_PASSES_DEFORM_IO_H
#include "render/shared/types.h"
DERMIS_IO_BEGIN
struct DeformIo {
  uint count;                                           // of the vertices to write
  uint position_stride, normal_stride, tangent_stride;  // floats; 0: not given
  uint first_position, first_normal, first_tangent;     // floats from where the stream is bound
};
DERMIS_IO_END
#ifdef __cplusplus
static_assert(sizeof(dermis::io::DeformIo) == 28);
#endif
#endif
