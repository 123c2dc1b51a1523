// SPDX-License-Identifier: MIT
// Curvature at the vertices of moved skin: curvatures() of head/scene/surface/curvature.cpp. Thickness stays:
// skin stretches, and hardly gets thinner.
#version 460
#include "render/passes/pose/move_rig/move_rig_io.h"
#include "render/shared/rig_io.h"
#include "render/shared/scene_io.h"
layout(local_size_x = 64) in;
layout(push_constant, scalar) uniform Push { MoveRigIo io; };
layout(binding = 0, scalar) readonly buffer Vertices { VertexIo vertices[]; };
layout(binding = 1, scalar) buffer SkinVertices { SkinVertexIo skin_vertices[]; };
layout(binding = 2, scalar) readonly buffer First { uint first_neighbour[]; };
layout(binding = 3, scalar) readonly buffer Neighbours { CurvatureNeighbourIo neighbours[]; };

// The neighbourhood of a vertex on its tangent plane.
struct Plane {
  vec3 position_m, normal, t, u;
};

Plane plane_at(uint v) {
  const vec3 n = vertices[v].normal, side = abs(n.x) < 0.6 ? vec3(1.0, 0.0, 0.0) : vec3(0.0, 1.0, 0.0);
  const vec3 t = normalize(cross(side, n));
  return Plane(vertices[v].position_m, n, t, cross(n, t));
}

// Position in mm and normal of a neighbour on the plane; its weight is 0 beyond a rim.
vec4 on_plane(Plane plane, uint k, out float weight) {
  const VertexIo other = vertices[neighbours[k].vertex];
  weight = dot(other.normal, plane.normal) > 0.0 ? neighbours[k].weight : 0.0;
  const vec3 d = (other.position_m - plane.position_m) * io.mm_per_unit;
  return vec4(dot(d, plane.t), dot(d, plane.u), dot(other.normal, plane.t), dot(other.normal, plane.u));
}

// eigenvalues() of head/scene/surface/curvature.cpp.
vec2 eigenvalues(vec3 x, vec3 b) {
  const float trace = x.x + x.z, determinant = trace * (x.x * x.z - x.y * x.y);
  if (!(determinant > 1e-6 * trace * trace * trace)) return vec2(0.0);
  const float s01 = (x.x * x.z * b.y - x.y * (x.z * b.x + x.x * b.z)) / determinant;
  const float s00 = (b.x - s01 * x.y) / x.x, s11 = (b.z - s01 * x.y) / x.z;
  return clamp(vec2(0.5 * (s00 + s11), length(vec2(0.5 * (s00 - s11), s01))), vec2(-2.0, 0.0), vec2(2.0));
}

void main() {
  if (gl_GlobalInvocationID.x >= io.count) return;
  const uint v = io.first + gl_GlobalInvocationID.x;
  const uint begin = first_neighbour[v], end = first_neighbour[v + 1u];
  if (end - begin < 3u) return;

  const Plane plane = plane_at(v);
  vec4 mean = vec4(0.0);
  float sum = 0.0, weight;
  for (uint k = begin; k < end; ++k) {
    const vec4 xm = on_plane(plane, k, weight);
    mean += weight * xm;
    sum += weight;
  }
  if (!(sum > 0.0)) return;
  mean /= sum;

  vec3 x = vec3(0.0), b = vec3(0.0);
  for (uint k = begin; k < end; ++k) {
    const vec4 xm = on_plane(plane, k, weight) - mean;
    x += weight * vec3(xm.x * xm.x, xm.x * xm.y, xm.y * xm.y);
    b += weight * vec3(xm.z * xm.x, xm.z * xm.y + xm.w * xm.x, xm.w * xm.y);
  }
  skin_vertices[v].curvature_per_mm = packHalf2x16(eigenvalues(x, b));
}
