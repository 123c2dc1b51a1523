// SPDX-License-Identifier: MIT
// Attributes of vertices of skin, beside vertex_pull.glsl.
#extension GL_EXT_samplerless_texture_functions : require
layout(binding = 35) uniform utextureBuffer SkinVertices;  // SkinVertexIo[]

vec2 unwrap_of(uint vertex) { return uintBitsToFloat(texelFetch(SkinVertices, int(2u * vertex)).xy); }

SkinVertexIo skin_vertex_at(uint vertex) {
  const uvec4 a = texelFetch(SkinVertices, int(2u * vertex)),
              b = texelFetch(SkinVertices, int(2u * vertex + 1u));
  return SkinVertexIo(uintBitsToFloat(a.xy), uintBitsToFloat(uvec3(a.zw, b.x)), b.y, b.z, b.w);
}

// Returns texture coordinates per mm: the geometric mean of two directions.
float uv_per_mm(vec3 metric_mm2) {
  const float determinant = max(metric_mm2.x * metric_mm2.z - metric_mm2.y * metric_mm2.y, 1e-12);
  return inversesqrt(sqrt(determinant));
}

// Returns mean and half difference of the principal curvatures per mm, the thickness of the body and the
// distance to the nearest open border in mm.
vec4 body_shape(SkinVertexIo skin) {
  return vec4(unpackHalf2x16(skin.curvature_per_mm), unpackHalf2x16(skin.body_mm));
}
