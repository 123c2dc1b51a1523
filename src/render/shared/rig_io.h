// SPDX-License-Identifier: MIT
// Joints, skins and morph targets that move the vertices of an asset.
#ifndef DERMIS_SHARED_RIG_IO_H
#define DERMIS_SHARED_RIG_IO_H
#include "render/shared/types.h"

DERMIS_IO_BEGIN

// In the coordinates of its mesh.
struct RigVertexIo {
  vec3 position;
  vec3 normal, tangent;                 // of any length
  uint first_influence, end_influence;  // none: the vertex stays where it is
  uint first_delta, end_delta;
};

struct InfluenceIo {
  uint matrix;
  float weight;  // those of a vertex sum to 1
};

// At weight 1.
struct MorphDeltaIo {
  vec3 position, normal, tangent;
  uint weight;  // number of its weight
};

// scene::CurvatureNeighbour
struct CurvatureNeighbourIo {
  uint vertex;
  float weight;
};
DERMIS_IO_END

#ifdef __cplusplus
static_assert(sizeof(dermis::io::RigVertexIo) == 13 * 4);
static_assert(sizeof(dermis::io::InfluenceIo) == 2 * 4);
static_assert(sizeof(dermis::io::MorphDeltaIo) == 10 * 4);
static_assert(sizeof(dermis::io::CurvatureNeighbourIo) == 2 * 4);
#endif
#endif
