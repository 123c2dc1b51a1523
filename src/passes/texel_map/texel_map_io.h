// SPDX-License-Identifier: MIT
#ifndef DERMIS_PASSES_TEXEL_MAP_IO_H
#define DERMIS_PASSES_TEXEL_MAP_IO_H
#include "shared/types.h"
DERMIS_IO_BEGIN
struct TexelDrawIo {
  uint vertices, instances, first_vertex, first_instance;  // VkDrawIndirectCommand
};
struct StaleTexelsIo {
  uint square;    // number in the pool
  uint stamp;     // of what it shall hold; 0: this frame's triangles, which nothing else can use
  uint vertices;  // of a draw of all of it
};
DERMIS_IO_END
#ifdef __cplusplus
static_assert(sizeof(dermis::io::TexelDrawIo) == 16);
static_assert(sizeof(dermis::io::StaleTexelsIo) == 12);
#endif
#endif
