// SPDX-License-Identifier: MIT
// One step of finding the curvature of a skin mesh: curvature_io.h.
#version 460
#include "render/passes/pose/curvature/curvature_io.h"
#include "render/shared/scene_io.h"
layout(constant_id = 0) const uint step = CURVATURE_BEGIN;
layout(local_size_x = 64) in;
layout(push_constant, scalar) uniform Push { CurvatureIo io; };
layout(binding = 0, scalar) readonly buffer Vertices { VertexIo vertices[]; };
layout(binding = 1, scalar) readonly buffer Indices { uint indices[]; };
layout(binding = 2, scalar) readonly buffer WeldedPoints { uint point_of[]; };
layout(binding = 3, scalar) buffer CurvaturePoints { CurvaturePointIo points[]; };
layout(binding = 4, scalar) writeonly buffer Curvature { float curvature_per_mm[]; };

int whole(float per_mm) { return int(round(clamp(per_mm, -4.0, 4.0) * CURVATURE_ONE)); }

// By how much the normal turns along the edge, over its length: positive where the skin bulges.
void bound_by_edge(uint i, uint j) {
  const vec3 along_mm = (vertices[j].position_m - vertices[i].position_m) * io.mm_per_unit;
  const float length2 = dot(along_mm, along_mm);
  if (!(length2 > 1e-12) || isinf(length2)) return;
  const int curvature = whole(dot(vertices[j].normal - vertices[i].normal, along_mm) / length2);
  atomicMin(points[point_of[i]].least, curvature);
  atomicMax(points[point_of[i]].most, curvature);
  atomicMin(points[point_of[j]].least, curvature);
  atomicMax(points[point_of[j]].most, curvature);
}

void spread_along_edge(uint i, uint j) {
  const uint a = point_of[i], b = point_of[j];
  atomicAdd(points[a].sum, whole(points[b].per_mm));
  atomicAdd(points[a].edges, 1);
  atomicAdd(points[b].sum, whole(points[a].per_mm));
  atomicAdd(points[b].edges, 1);
}

void main() {
  const uint n = gl_GlobalInvocationID.y * gl_NumWorkGroups.x * gl_WorkGroupSize.x + gl_GlobalInvocationID.x;
  if (n >= io.count) return;

  if (step == CURVATURE_BEGIN) {
    points[n] = CurvaturePointIo(0x7fffffff, -0x7fffffff, 0, 0, 0.0);
  } else if (step == CURVATURE_EDGES || step == CURVATURE_SPREAD) {
    for (uint k = 0u; k < 3u; ++k) {
      const uint i = indices[3u * n + k], j = indices[3u * n + (k + 1u) % 3u];
      if (step == CURVATURE_EDGES)
        bound_by_edge(i, j);
      else
        spread_along_edge(i, j);
    }
  } else if (step == CURVATURE_MEAN) {
    const CurvaturePointIo p = points[n];
    if (p.least <= p.most) points[n].per_mm = 0.5 * (float(p.least) + float(p.most)) / CURVATURE_ONE;
  } else if (step == CURVATURE_SMOOTH) {
    const CurvaturePointIo p = points[n];
    if (p.edges > 0) points[n].per_mm = 0.5 * (p.per_mm + float(p.sum) / float(p.edges) / CURVATURE_ONE);
    points[n].sum = 0;
    points[n].edges = 0;
  } else {
    curvature_per_mm[n] = points[point_of[n]].per_mm;
  }
}
