// SPDX-License-Identifier: MIT
#version 460
#include "render/techniques/published/final_io.h"
#include "render/shared/scene_io.h"
#include "render/shaders/vertex_pull.glsl"
#include "render/shaders/skin_vertex.glsl"
#include "render/shaders/first_corner.glsl"
#include "render/shaders/head.glsl"
layout(push_constant, scalar) uniform Push { PaperFinalIo io; };
#include "render/shaders/frame.glsl"
#include "render/shaders/bulge.glsl"

invariant gl_Position;  // unshaded_reads.frag tests against the depth written here
layout(location = 0) out vec3 out_position_m;
layout(location = 1) out vec3 out_normal;
layout(location = 2) out vec4 out_tangent;
layout(location = 3) out vec4 out_uv;
layout(location = 4) out vec4 out_colour;
layout(location = 5) centroid out vec2 out_unwrap;
layout(location = 6) flat out vec4 out_unwrap_ab;  // of the triangle's corners
layout(location = 7) flat out vec2 out_unwrap_c;
layout(location = 8) out float out_plane_m;

void main() {
  const uint vertex = vertex_drawn();
  const VertexIo v = vertex_at(vertex);
  const VertexExtraIo extra = vertex_extra(vertex);

  out_position_m = world_position(v.position_m);
  out_normal = world_direction(v.normal);
  out_plane_m = plane_distance(out_position_m, out_normal);
  out_tangent = vec4(world_direction(v.tangent.xyz), v.tangent.w);
  out_uv = vec4(v.uv0, extra.uv1);
  out_colour = extra.colour;
  out_unwrap = unwrap_of(vertex);

  const uint first = is_first_corner() ? 3u * gl_VertexIndex : 0u;
  out_unwrap_ab = vec4(unwrap_of(indices[first]), unwrap_of(indices[first + 1]));
  out_unwrap_c = unwrap_of(indices[first + 2]);
  gl_Position = clip_position(out_position_m);
}
