// SPDX-License-Identifier: MIT
// The rotation of each vertex from how its asset was loaded to its pose.
#version 460
#include "render/passes/pose/turn_sky/turn_sky_io.h"
#include "render/shared/scene_io.h"
layout(local_size_x = 64) in;
layout(push_constant, scalar) uniform Push { TurnSkyIo io; };
layout(binding = 0, scalar) readonly buffer Vertices { VertexIo vertices[]; };
layout(binding = 1, scalar) readonly buffer RestVertices { VertexIo rest_vertices[]; };
layout(binding = 2, scalar) writeonly buffer Turns { vec4 turns[]; };

// Returns normal, tangent and the direction across both; without a tangent the latter two are 0.
mat3 frame_of(VertexIo v) {
  const vec3 along = v.tangent.xyz - v.normal * dot(v.normal, v.tangent.xyz);
  const vec3 tangent = dot(along, along) < 1e-12 ? vec3(0.0) : normalize(along);
  return mat3(v.normal, tangent, cross(v.normal, tangent));
}

// Returns the unit quaternion (x, y, z, w) of a rotation, from the largest of its four components.
vec4 quaternion_of(mat3 r) {
  const vec4 squares = vec4(1.0 + r[0][0] - r[1][1] - r[2][2], 1.0 - r[0][0] + r[1][1] - r[2][2],
                            1.0 - r[0][0] - r[1][1] + r[2][2], 1.0 + r[0][0] + r[1][1] + r[2][2]);
  const vec3 differences = vec3(r[1][2] - r[2][1], r[2][0] - r[0][2], r[0][1] - r[1][0]),
             sums = vec3(r[1][2] + r[2][1], r[2][0] + r[0][2], r[0][1] + r[1][0]);
  const float largest = max(max(squares.x, squares.y), max(squares.z, squares.w));
  if (squares.w == largest) return normalize(vec4(differences, squares.w));
  if (squares.x == largest) return normalize(vec4(squares.x, sums.z, sums.y, differences.x));
  if (squares.y == largest) return normalize(vec4(sums.z, squares.y, sums.x, differences.y));
  return normalize(vec4(sums.y, sums.x, squares.z, differences.z));
}

// Returns the shortest rotation from one unit vector to another.
vec4 shortest_turn(vec3 from, vec3 to) {
  const vec4 q = vec4(cross(from, to), 1.0 + dot(from, to));
  return dot(q, q) > 1e-12 ? normalize(q) : vec4(0.0, 0.0, 0.0, 1.0);
}

void main() {
  if (gl_GlobalInvocationID.x >= io.count) return;
  const uint i = io.first + gl_GlobalInvocationID.x;
  const mat3 rest = frame_of(rest_vertices[i]), posed = frame_of(vertices[i]);
  const bool known = dot(rest[1], rest[1]) > 0.5 && dot(posed[1], posed[1]) > 0.5;
  turns[i] = known ? quaternion_of(posed * transpose(rest)) : shortest_turn(rest[0], posed[0]);
}
