// SPDX-License-Identifier: MIT
#version 460
#extension GL_GOOGLE_include_directive : require
#include "common.glsl"
layout(local_size_x = 64) in;
layout(scalar, binding = 0) readonly buffer From { vec3 values[]; }
from;
layout(scalar, binding = 3) writeonly buffer To { float values[]; }
to;
layout(scalar, push_constant) uniform Push {
  vec3 weights;
  uint count;
}
push;
void main() {
  const uint i = gl_GlobalInvocationID.x;
  if (i < push.count) to.values[i] = dot(from.values[i], push.weights);
}
