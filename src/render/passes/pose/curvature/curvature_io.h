// SPDX-License-Identifier: MIT
#ifndef DERMIS_PASSES_CURVATURE_IO_H
#define DERMIS_PASSES_CURVATURE_IO_H
#include "render/shared/types.h"
// Steps of curvature.comp, its specialisation constant.
#define CURVATURE_BEGIN 0u   // per point: nothing is known
#define CURVATURE_EDGES 1u   // per triangle: its edges bound the curvature at their ends
#define CURVATURE_MEAN 2u    // per point: the mean of both bounds
#define CURVATURE_SPREAD 3u  // per triangle: along its edges, ends learn of each other
#define CURVATURE_SMOOTH 4u  // per point: half of what its neighbours have
#define CURVATURE_FINISH 5u  // per vertex: that of its point
// Curvatures are added as whole numbers, so that the order of adding does not matter.
#define CURVATURE_ONE 65536.0  // 1/mm
DERMIS_IO_BEGIN
struct CurvatureIo {
  uint count;         // of points, triangles or vertices, whatever the step goes over
  float mm_per_unit;  // mm of the asset per metre of its vertices
};
// Of a point: all vertices at one place, by the number of one of them.
struct CurvaturePointIo {
  int least, most;  // of its edges
  int sum, edges;   // of the points at the other ends
  float per_mm;
};
DERMIS_IO_END
#ifdef __cplusplus
static_assert(sizeof(dermis::io::CurvaturePointIo) == 20);
#endif
#endif
