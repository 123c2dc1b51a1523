// SPDX-License-Identifier: MIT
// The metric of the unwrap at the vertices of moved skin: the means of compute_metric() of
// head/scene/surface/metric.cpp.
// Triangles that are left out there, as slivers, are those of the asset as it was loaded.
#version 460
#include "render/passes/pose/move_rig/move_rig_io.h"
#include "render/shared/scene_io.h"
layout(local_size_x = 64) in;
layout(push_constant, scalar) uniform Push { MoveRigIo io; };
layout(binding = 0, scalar) readonly buffer Vertices { VertexIo vertices[]; };
layout(binding = 1, scalar) buffer SkinVertices { SkinVertexIo skin_vertices[]; };
layout(binding = 2, scalar) readonly buffer Indices { uint indices[]; };
layout(binding = 3, scalar) readonly buffer MetricTriangles { uint metric_triangles[]; };
layout(binding = 4, scalar) readonly buffer AtRest { SkinVertexIo at_rest[]; };

// g = J^T J times the area on the map, and that area; 0 if the triangle has none.
vec4 weighted_metric(uint triangle) {
  const uint a = indices[3u * triangle], b = indices[3u * triangle + 1u], c = indices[3u * triangle + 2u];
  const vec3 e1 = (vertices[b].position_m - vertices[a].position_m) * io.mm_per_unit,
             e2 = (vertices[c].position_m - vertices[a].position_m) * io.mm_per_unit;
  const vec2 d1 = skin_vertices[b].unwrap - skin_vertices[a].unwrap,
             d2 = skin_vertices[c].unwrap - skin_vertices[a].unwrap;
  const float area2 = d1.x * d2.y - d2.x * d1.y;
  if (area2 == 0.0) return vec4(0.0);

  const vec3 dp_du = (d2.y * e1 - d1.y * e2) / area2, dp_dv = (d1.x * e2 - d2.x * e1) / area2;
  const vec3 g = vec3(dot(dp_du, dp_du), dot(dp_du, dp_dv), dot(dp_dv, dp_dv));
  const bool valid = !any(isinf(g)) && !any(isnan(g)) && g.x * g.z - g.y * g.y > 1e-7 * g.x * g.z;
  return valid ? vec4(g, 1.0) * 0.5 * abs(area2) : vec4(0.0);
}

// Raises the smaller eigenvalue to large / 300^2.
vec3 well_conditioned(vec3 g) {
  const float large = 0.5 * (g.x + g.z) + length(vec2(0.5 * (g.x - g.z), g.y));
  const float small = (g.x * g.z - g.y * g.y) / large;
  const float lift = max(0.0, large / 9e4 - small);
  return g + vec3(lift, 0.0, lift);
}

void main() {
  if (gl_GlobalInvocationID.x >= io.count) return;
  const uint v = io.first + gl_GlobalInvocationID.x;
  vec4 sum = vec4(0.0);
  for (uint k = metric_triangles[v]; k < metric_triangles[v + 1u]; ++k)
    sum += weighted_metric(metric_triangles[k]);
  // Where all triangles have collapsed, that of the asset: a pose does not depend on the one before.
  skin_vertices[v].metric_mm2 = sum.w > 0.0 ? well_conditioned(sum.xyz / sum.w) : at_rest[v].metric_mm2;
}
