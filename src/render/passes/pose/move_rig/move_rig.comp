// SPDX-License-Identifier: MIT
// Morph targets, then joints: the same sums as move_vertex() of head/scene/rig/rig.cpp.
#version 460
#include "render/passes/pose/move_rig/move_rig_io.h"
#include "render/shared/rig_io.h"
#include "render/shared/scene_io.h"
layout(local_size_x = 64) in;
layout(push_constant, scalar) uniform Push { MoveRigIo io; };
layout(binding = 0, scalar) buffer Vertices { VertexIo vertices[]; };
layout(binding = 1, scalar) writeonly buffer Before { vec3 before_m[]; };
layout(binding = 2, scalar) readonly buffer RigVertices { RigVertexIo rig_vertices[]; };
layout(binding = 3, scalar) readonly buffer Influences { InfluenceIo influences[]; };
layout(binding = 4, scalar) readonly buffer MorphDeltas { MorphDeltaIo deltas[]; };
layout(binding = 5, scalar) readonly buffer Matrices { mat4x3 matrices[]; };
layout(binding = 6, scalar) readonly buffer Weights { float weights[]; };

vec3 unit_or(vec3 v, vec3 otherwise) {
  const float length2 = dot(v, v);
  return length2 > 1e-30 && !isinf(length2) ? v * inversesqrt(length2) : otherwise;
}

void main() {
  if (gl_GlobalInvocationID.x >= io.count) return;
  const uint i = io.first + gl_GlobalInvocationID.x;
  const RigVertexIo rig = rig_vertices[i];
  before_m[i] = vertices[i].position_m;
  if (rig.first_influence == rig.end_influence) return;

  vec3 p = rig.position, n = rig.normal, t = rig.tangent;
  for (uint d = rig.first_delta; d < rig.end_delta; ++d) {
    const float weight = weights[deltas[d].weight];
    p += weight * deltas[d].position;
    n += weight * deltas[d].normal;
    t += weight * deltas[d].tangent;
  }

  mat4x3 m = mat4x3(0.0);
  for (uint k = rig.first_influence; k < rig.end_influence; ++k)
    m += influences[k].weight * matrices[influences[k].matrix];

  // Cofactors are |M| M^-T without division by |M|; under a mirror, normals keep pointing outwards.
  mat3 cofactors = mat3(cross(m[1], m[2]), cross(m[2], m[0]), cross(m[0], m[1]));
  if (dot(m[0], cofactors[0]) < 0.0) cofactors = -cofactors;

  // Where a matrix leaves no direction, one that does not depend on the pose before.
  vertices[i].position_m = m * vec4(p, 1.0);
  const vec3 normal = unit_or(cofactors * n, unit_or(rig.normal, vec3(0.0, 0.0, 1.0)));
  vertices[i].normal = normal;
  const vec3 along = mat3(m) * t;
  vertices[i].tangent.xyz =
      unit_or(along - normal * dot(normal, along), unit_or(rig.tangent, vec3(1.0, 0.0, 0.0)));
}
