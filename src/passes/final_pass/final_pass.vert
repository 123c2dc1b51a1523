// SPDX-License-Identifier: MIT
#version 460
#include "passes/final_pass/final_pass_io.h"
#include "shared/scene_io.h"
#include "shaders/vertex_pull.glsl"
#include "shaders/instance.glsl"
layout(push_constant, scalar) uniform Push { FinalPassIo io; };
#include "shaders/frame.glsl"
invariant gl_Position;  // unshaded_reads.frag tests against the depth written here
layout(location = 0) out vec3 out_position_m;
layout(location = 1) out vec3 out_normal;
layout(location = 2) out vec4 out_tangent;
layout(location = 3) out vec4 out_uv;
layout(location = 4) out vec4 out_colour;
layout(location = 5) centroid out vec2 out_unwrap;
layout(location = 6) flat out vec4 out_unwrap_ab;  // of the triangle's corners
layout(location = 7) flat out vec2 out_unwrap_c;
layout(location = 8) out float out_uv_per_mm;  // texture coordinates per mm: geometric mean of two directions
void main() {
  const VertexIo v = pulled_vertex();
  out_position_m = world_position(v.position_m);
  out_normal = world_direction(v.normal);
  out_tangent = vec4(world_direction(v.tangent.xyz), v.tangent.w);
  out_uv = vec4(v.uv0, v.uv1);
  out_colour = v.colour;
  out_unwrap = v.unwrap;
  const float determinant = max(v.metric_mm2.x * v.metric_mm2.z - v.metric_mm2.y * v.metric_mm2.y, 1e-12);
  out_uv_per_mm = inversesqrt(sqrt(determinant));
  const int first = gl_VertexIndex / 3 * 3;
  out_unwrap_ab = vec4(vertices[indices[first]].unwrap, vertices[indices[first + 1]].unwrap);
  out_unwrap_c = vertices[indices[first + 2]].unwrap;
  gl_Position = frame.camera.clip_from_world * vec4(out_position_m, 1.0);
}
