// SPDX-License-Identifier: MIT
// A placement of a mesh that is not skin: its vertices are in its own coordinates, or in the world if there
// is one copy.
#ifndef DERMIS_SHARED_PLACEMENT_IO_H
#define DERMIS_SHARED_PLACEMENT_IO_H
#include "render/shared/types.h"

DERMIS_IO_BEGIN

struct PlacementIo {
  vec3 x_axis, y_axis, z_axis;        // images of the mesh's axes, m
  vec3 origin_m;                      // and of its origin
  vec3 normal_x, normal_y, normal_z;  // columns of the matrix of normals, up to a positive factor
  float handedness;                   // factor on tangent.w: -1 if mirrored; 0: the vertices are in the world
};

DERMIS_IO_END

#ifdef __cplusplus
static_assert(sizeof(dermis::io::PlacementIo) == 22 * 4);
#endif
#endif
