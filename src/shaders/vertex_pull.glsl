// SPDX-License-Identifier: MIT
// Reads vertices from storage buffers: no vertex input state, and a shader knows its triangle.
layout(binding = 0, scalar) readonly buffer Vertices { VertexIo vertices[]; };
layout(binding = 1, scalar) readonly buffer Indices { uint indices[]; };
VertexIo pulled_vertex() { return vertices[indices[gl_VertexIndex]]; }
