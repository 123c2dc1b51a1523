// SPDX-License-Identifier: MIT
#ifndef DERMIS_SHARED_SHAPE_IO_H
#define DERMIS_SHARED_SHAPE_IO_H
#include "render/shared/types.h"
DERMIS_IO_BEGIN
// The laws of a profile: ShapeLaws of dermis/profile.h, in mm of the asset.
struct ShapeIo {
  vec3 curvature_mm, convex_mm, concave_mm, difference_mm, difference_mm2;
  vec3 front_share, front_per_mm;
  vec3 exit_grazing, exit_change;  // normal minus grazing
};
DERMIS_IO_END
#ifdef __cplusplus
static_assert(sizeof(dermis::io::ShapeIo) == 27 * 4);
#endif
#endif
