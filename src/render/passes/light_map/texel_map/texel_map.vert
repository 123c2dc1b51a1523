// SPDX-License-Identifier: MIT
// A triangle over the whole square, which clears it, then those of the mesh in its texture coordinates.
// Without index buffer: each triangle has its own number, and is drawn seldom.
#version 460
#include "render/shared/scene_io.h"
#include "render/shaders/skin_vertex.glsl"
layout(binding = 1, scalar) readonly buffer Indices { uint indices[]; };
layout(location = 0) flat out uint out_number;

void main() {
  const uint vertex = uint(gl_VertexIndex);
  out_number = vertex / 3u;
  vec2 at = vec2(vertex & 1u, vertex >> 1) * 4.0 - 1.0;
  if (vertex >= 3u) at = unwrap_of(indices[vertex - 3u]) * 2.0 - 1.0;
  gl_Position = vec4(at, 0.5, 1.0);
}
