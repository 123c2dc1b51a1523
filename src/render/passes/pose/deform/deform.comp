// SPDX-License-Identifier: MIT
// Moves the vertices of a skin mesh to where a host has them.
#version 460
#include "render/passes/pose/deform/deform_io.h"
#include "render/shared/scene_io.h"
#include "render/shared/sources_io.h"
layout(local_size_x = 64) in;
layout(push_constant, scalar) uniform Push { DeformIo io; };
layout(binding = 0, scalar) buffer Vertices { VertexIo vertices[]; };
layout(binding = 1, scalar) readonly buffer Sources { SourceVertexIo sources[]; };
layout(binding = 2, scalar) readonly buffer Positions { float positions_m[]; };
layout(binding = 3, scalar) readonly buffer Normals { float normals[]; };
layout(binding = 4, scalar) readonly buffer Tangents { float tangents[]; };

// A direction that is none stays as it was.
vec3 unit_or(vec3 v, vec3 otherwise) {
  const float length2 = dot(v, v);
  return length2 > 1e-30 && !isinf(length2) ? v * inversesqrt(length2) : otherwise;
}

void main() {
  const uint i = gl_GlobalInvocationID.x;
  if (i >= io.count) return;
  const uint to = sources[i].vertex, from = sources[i].source;

  if (io.position_stride != 0u) {
    const uint at = io.first_position + from * io.position_stride;
    vertices[to].position_m = vec3(positions_m[at], positions_m[at + 1], positions_m[at + 2]);
  }

  vec3 n = vertices[to].normal;
  if (io.normal_stride != 0u) {
    const uint at = io.first_normal + from * io.normal_stride;
    n = unit_or(vec3(normals[at], normals[at + 1], normals[at + 2]), n);
    vertices[to].normal = n;
  }

  vec3 t = vertices[to].tangent.xyz;
  if (io.tangent_stride != 0u) {
    const uint at = io.first_tangent + from * io.tangent_stride;
    t = unit_or(vec3(tangents[at], tangents[at + 1], tangents[at + 2]), t);
  }
  // Perpendicular to the new normal, also where the host gives no tangents.
  vertices[to].tangent.xyz = unit_or(t - n * dot(n, t), t);
}
