// SPDX-License-Identifier: MIT
// Vertices of draws with GpuMesh::first_corners, whose shaders know their
// triangle. Index t is the first corner of triangle t, and of no other. Indices from triangle_count() on are
// vertices without a triangle. Flat outputs are those of the first corner. Needs vertex_pull.glsl.
layout(binding = 1, scalar) readonly buffer Indices { uint indices[]; };  // GpuMesh::indices

uint triangle_count() { return uint(indices.length()) / 3u; }
bool is_first_corner() { return uint(gl_VertexIndex) < triangle_count(); }
uint vertex_drawn() {
  return is_first_corner() ? indices[3u * uint(gl_VertexIndex)] : uint(gl_VertexIndex) - triangle_count();
}
