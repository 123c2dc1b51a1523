// SPDX-License-Identifier: MIT
// Vertices of meshes with placements: the number of the instance is that of its placement. Needs
// vertex_pull.glsl.
#include "render/shared/placement_io.h"
layout(binding = 31, scalar) readonly buffer Placements { PlacementIo placements[]; };

vec3 unit_or(vec3 v, vec3 otherwise) {
  const float length2 = dot(v, v);
  return length2 > 1e-30 ? v * inversesqrt(length2) : otherwise;
}

vec3 placed_position(PlacementIo p, vec3 position_m) {
  if (p.handedness == 0.0) return position_m;
  return p.x_axis * position_m.x + p.y_axis * position_m.y + p.z_axis * position_m.z + p.origin_m;
}

VertexIo placed_vertex() {
  VertexIo v = vertex_at(gl_VertexIndex);
  const PlacementIo p = placements[gl_InstanceIndex];
  v.position_m = placed_position(p, v.position_m);
  if (p.handedness == 0.0) return v;
  v.normal = unit_or(p.normal_x * v.normal.x + p.normal_y * v.normal.y + p.normal_z * v.normal.z,
                     vec3(0.0, 0.0, 1.0));
  const vec3 t = p.x_axis * v.tangent.x + p.y_axis * v.tangent.y + p.z_axis * v.tangent.z;
  const vec3 any = abs(v.normal.x) < 0.9 ? vec3(1.0, 0.0, 0.0) : vec3(0.0, 1.0, 0.0);
  v.tangent.xyz = unit_or(t - v.normal * dot(v.normal, t), normalize(any - v.normal * dot(v.normal, any)));
  v.tangent.w *= p.handedness;
  return v;
}
