// SPDX-License-Identifier: MIT
// The mesh laid out in its own texture coordinates.
#version 460
#include "render/shared/scene_io.h"
#include "render/shaders/vertex_pull.glsl"
#include "render/shaders/skin_vertex.glsl"
layout(location = 0) out vec3 out_metric;
layout(location = 1) flat out uint out_chart;
layout(location = 2) out vec4 out_uv;
layout(location = 3) out vec4 out_colour;
void main() {
  const SkinVertexIo skin = skin_vertex_at(gl_VertexIndex);
  const VertexExtraIo extra = vertex_extra(gl_VertexIndex);
  out_metric = skin.metric_mm2;
  out_chart = skin.chart;
  out_uv = vec4(vertex_at(gl_VertexIndex).uv0, extra.uv1);
  out_colour = extra.colour;
  gl_Position = vec4(skin.unwrap * 2.0 - 1.0, 0.5, 1.0);
}
