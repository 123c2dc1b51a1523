// SPDX-License-Identifier: MIT
// [DLE07] sec. 3.2: the vertex shader maps the mesh to its texture coordinates. CLIP: [JG08] sec. 5, listing
// 4, clips it against the view all the same.
// Variant irradiance_clipped.vert: CLIP
#version 460
#include "render/shared/scene_io.h"
#include "render/shaders/vertex_pull.glsl"
#include "render/shaders/skin_vertex.glsl"
#include "render/shaders/head.glsl"
#include "render/shaders/frame.glsl"
#include "render/shaders/bulge.glsl"

layout(location = 0) out vec3 out_position_m;
layout(location = 1) out vec3 out_normal;
layout(location = 2) out vec4 out_tangent;
layout(location = 3) out vec4 out_uv;
layout(location = 4) out vec4 out_colour;
layout(location = 5) flat out uint out_chart;
layout(location = 6) out vec2 out_unwrap;
layout(location = 7) out float out_plane_m;

#ifdef CLIP
out gl_PerVertex {
  vec4 gl_Position;
  float gl_ClipDistance[5];
};
#endif

void main() {
  const VertexIo v = vertex_at(gl_VertexIndex);
  const VertexExtraIo extra = vertex_extra(gl_VertexIndex);
  const SkinVertexIo skin = skin_vertex_at(gl_VertexIndex);

  out_position_m = world_position(v.position_m);
  out_normal = world_direction(v.normal);
  out_plane_m = plane_distance(out_position_m, out_normal);
  out_tangent = vec4(world_direction(v.tangent.xyz), v.tangent.w);
  out_uv = vec4(v.uv0, extra.uv1);
  out_colour = extra.colour;
  out_chart = skin.chart;
  out_unwrap = skin.unwrap;

  gl_Position = vec4(skin.unwrap * 2.0 - 1.0, 0.5, 1.0);
#ifdef CLIP
  // [JG08] eq. 5 and 6: the planes of the view, D = 1, and frame.clip_margin_m beside them. Departures: the
  // margin is as wide as the profile reaches, for light from just outside still arrives
  // (quality.clip_margin_mm 0 is the paper's rule). Planes and points are those of the world; there is no far
  // plane.
  for (int i = 0; i < 5; ++i) gl_ClipDistance[i] = distance_inside(i, out_position_m);
#endif
}
