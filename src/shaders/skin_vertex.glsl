// SPDX-License-Identifier: MIT
// What vertices of skin have beside vertex_pull.glsl.
layout(binding = 35, scalar) readonly buffer SkinVertices { SkinVertexIo skin_vertices[]; };
