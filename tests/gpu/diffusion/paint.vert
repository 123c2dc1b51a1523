// SPDX-License-Identifier: MIT
#version 460
#include "render/shared/scene_io.h"
#include "render/shaders/vertex_pull.glsl"
#include "render/shaders/skin_vertex.glsl"
layout(location = 0) out vec3 out_position_m;
layout(location = 1) flat out uint out_chart;
void main() {
  out_position_m = vertex_position(gl_VertexIndex);
  out_chart = skin_vertex_at(gl_VertexIndex).chart;
  gl_Position = vec4(unwrap_of(gl_VertexIndex) * 2.0 - 1.0, 0.5, 1.0);
}
