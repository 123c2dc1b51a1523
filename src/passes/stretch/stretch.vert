// SPDX-License-Identifier: MIT
// The mesh laid out in its own texture coordinates.
#version 460
#include "shared/scene_io.h"
#include "shaders/vertex_pull.glsl"
layout(binding = 13, scalar) readonly buffer Charts { uint charts[]; };
layout(location = 0) out vec3 out_metric;
layout(location = 1) flat out uint out_chart;
layout(location = 2) out vec4 out_uv;
layout(location = 3) out vec4 out_colour;
void main() {
  const VertexIo v = pulled_vertex();
  out_metric = v.metric_mm2;
  out_chart = charts[gl_VertexIndex / 3];
  out_uv = vec4(v.uv0, v.uv1);
  out_colour = v.colour;
  gl_Position = vec4(v.unwrap * 2.0 - 1.0, 0.5, 1.0);
}
