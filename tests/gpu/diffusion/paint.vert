// SPDX-License-Identifier: MIT
#version 460
#include "shared/scene_io.h"
#include "shaders/vertex_pull.glsl"
#include "shaders/skin_vertex.glsl"
layout(location = 0) out vec3 out_position_m;
layout(location = 1) flat out uint out_chart;
void main() {
  out_position_m = vertices[gl_VertexIndex].position_m;
  out_chart = skin_vertices[gl_VertexIndex].chart;
  gl_Position = vec4(skin_vertices[gl_VertexIndex].unwrap * 2.0 - 1.0, 0.5, 1.0);
}
