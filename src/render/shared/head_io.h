// SPDX-License-Identifier: MIT
#ifndef DERMIS_SHARED_HEAD_IO_H
#define DERMIS_SHARED_HEAD_IO_H
#include "render/shared/scene_io.h"
DERMIS_IO_BEGIN
// Place of an instance of an asset in the world: turned, scaled, then moved.
struct InstanceIo {
  vec3 x_axis, y_axis, z_axis;  // unit: images of the asset's axes
  vec3 origin_m;                // image of its origin
  float scale;                  // > 0
};
// Data that differ from head to head, in one buffer: devices may have no more than 32 bindings.
struct HeadIo {
  InstanceIo instance;
  LampsIo lamps;
};
DERMIS_IO_END
#ifdef __cplusplus
static_assert(sizeof(dermis::io::InstanceIo) == 13 * 4);
#endif
#endif
