// SPDX-License-Identifier: MIT
// Reads vertices from buffers, without vertex input state. Draws are indexed: a vertex that triangles share
// is shaded once while the device remembers it. The buffers are read as texels of 16 bytes
// (gpu::texel_format).
#extension GL_EXT_samplerless_texture_functions : require
layout(binding = 0) uniform utextureBuffer Vertices;      // VertexIo[]
layout(binding = 6) uniform utextureBuffer VertexExtras;  // VertexExtraIo[]

vec3 vertex_position(uint vertex) { return uintBitsToFloat(texelFetch(Vertices, int(3u * vertex)).xyz); }

VertexIo vertex_at(uint vertex) {
  const int first = int(3u * vertex);
  const vec4 a = uintBitsToFloat(texelFetch(Vertices, first)),
             b = uintBitsToFloat(texelFetch(Vertices, first + 1)),
             c = uintBitsToFloat(texelFetch(Vertices, first + 2));
  return VertexIo(a.xyz, vec3(a.w, b.xy), vec4(b.zw, c.xy), c.zw);
}

VertexExtraIo vertex_extra(uint vertex) {
  const int first = min(int(2u * vertex), textureSize(VertexExtras) - 2);
  const vec4 colour = uintBitsToFloat(texelFetch(VertexExtras, first)),
             rest = uintBitsToFloat(texelFetch(VertexExtras, first + 1));
  return VertexExtraIo(colour, rest.xy, rest.zw);
}
