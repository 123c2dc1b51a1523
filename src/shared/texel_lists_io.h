// SPDX-License-Identifier: MIT
// Lists of the texels of light maps that a frame lights: one per square and material.
#ifndef DERMIS_SHARED_TEXEL_LISTS_IO_H
#define DERMIS_SHARED_TEXEL_LISTS_IO_H
#include "shared/types.h"
DERMIS_IO_BEGIN
struct TexelListIo {
  uint count;    // of its texels
  uint first;    // of its entries, among those of the square
  uint written;  // entries, if they were counted before
};
struct TexelArgumentsIo {
  uint groups[3];  // VkDispatchIndirectCommand over the texels of a list
};
DERMIS_IO_END

// Texels of a workgroup; workgroups in x of an indirect dispatch, because all devices allow 65535.
#define TEXEL_GROUP 64
#define TEXEL_ROW 32768

#ifdef __cplusplus
static_assert(sizeof(dermis::io::TexelListIo) == 12);
#endif
#endif
