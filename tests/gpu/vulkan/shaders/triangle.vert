// SPDX-License-Identifier: MIT
#version 460
#extension GL_GOOGLE_include_directive : require
#include "common.glsl"
struct Vertex {
  vec3 position;
  vec3 colour;
};
layout(constant_id = 0) const bool mirrored = false;
layout(scalar, binding = 0) readonly buffer Vertices { Vertex all[]; }
vertices;
layout(scalar, push_constant) uniform Push { float opacity; }
push;
layout(location = 0) out vec4 colour;
void main() {
  const Vertex vertex = vertices.all[gl_VertexIndex];
  gl_Position = vec4(mirrored ? -vertex.position.x : vertex.position.x, vertex.position.yz, 1);
  colour = vec4(vertex.colour, 1) * push.opacity;
}
