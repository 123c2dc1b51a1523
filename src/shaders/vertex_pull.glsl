// SPDX-License-Identifier: MIT
// Reads vertices from storage buffers, without vertex input state. Draws are indexed: a vertex that triangles
// share is shaded once while the device remembers it.
layout(binding = 0, scalar) readonly buffer Vertices { VertexIo vertices[]; };
layout(binding = 6, scalar) readonly buffer VertexExtras { VertexExtraIo vertex_extras[]; };

VertexExtraIo vertex_extra(uint vertex) {
  return vertex_extras[min(vertex, uint(vertex_extras.length()) - 1u)];
}
