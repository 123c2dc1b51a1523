// SPDX-License-Identifier: MIT
// Reads chosen texels of chosen mips and layers.
#version 460
#extension GL_GOOGLE_include_directive : require
#include "common.glsl"
layout(local_size_x = 1) in;
layout(binding = 0) uniform sampler2DArray map;
layout(scalar, binding = 1) writeonly buffer To { vec4 values[]; }
to;
layout(scalar, push_constant) uniform Push {
  vec3 place;
  float mip;
}
push;
void main() { to.values[0] = textureLod(map, push.place, push.mip); }
