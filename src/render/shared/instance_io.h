// SPDX-License-Identifier: MIT
#ifndef DERMIS_SHARED_INSTANCE_IO_H
#define DERMIS_SHARED_INSTANCE_IO_H
#include "render/shared/types.h"
DERMIS_IO_BEGIN
// Place of an instance of an asset in the world: turned, scaled, then moved.
struct InstanceIo {
  vec3 x_axis, y_axis, z_axis;  // unit: images of the asset's axes
  vec3 origin_m;                // image of its origin
  float scale;                  // > 0
};
DERMIS_IO_END
#ifdef __cplusplus
static_assert(sizeof(dermis::io::InstanceIo) == 13 * 4);
#endif
#endif
