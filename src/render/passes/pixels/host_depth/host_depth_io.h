// SPDX-License-Identifier: MIT
#ifndef DERMIS_PASSES_HOST_DEPTH_IO_H
#define DERMIS_PASSES_HOST_DEPTH_IO_H
#include "render/shared/scene_io.h"
#include "render/shared/types.h"
DERMIS_IO_BEGIN
struct HostDepthIo {
  mat4 clip_from_world;
  SimilarityIo world_from_asset;
};
DERMIS_IO_END
#ifdef __cplusplus
static_assert(sizeof(dermis::io::HostDepthIo) == 116);
#endif
#endif
