// SPDX-License-Identifier: MIT
#version 460
#include "shared/scene_io.h"
#include "shaders/vertex_pull.glsl"
layout(binding = 2, scalar) readonly buffer Charts { uint charts[]; };
layout(location = 0) out vec3 out_position_m;
layout(location = 1) flat out uint out_chart;
void main() {
  const VertexIo v = pulled_vertex();
  out_position_m = v.position_m;
  out_chart = charts[gl_VertexIndex / 3];
  gl_Position = vec4(v.unwrap * 2.0 - 1.0, 0.5, 1.0);
}
