// SPDX-License-Identifier: MIT
#version 460
#extension GL_GOOGLE_include_directive : require
#include "common.glsl"
layout(local_size_x = 8, local_size_y = 8) in;
layout(rgba16f, binding = 0) writeonly uniform image2D target;
layout(scalar, binding = 1) uniform Scale { vec4 factor; }
scale;
void main() {
  const ivec2 at = ivec2(gl_GlobalInvocationID.xy);
  if (all(lessThan(at, imageSize(target)))) imageStore(target, at, vec4(at, 1, 1) * scale.factor);
}
