// SPDX-License-Identifier: MIT
// Writes the texels of a buffer, the last one first, and then how many there are.
#version 460
#extension GL_EXT_samplerless_texture_functions : require
#extension GL_EXT_scalar_block_layout : require
layout(local_size_x = 4) in;
layout(binding = 0) uniform utextureBuffer From;
layout(scalar, binding = 1) writeonly buffer To { uvec4 values[]; }
to;

void main() {
  const int i = int(gl_GlobalInvocationID.x), count = textureSize(From);
  if (i < count) to.values[count - 1 - i] = texelFetch(From, i);
  if (i == count) to.values[count] = uvec4(count);
}
