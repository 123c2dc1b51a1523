// SPDX-License-Identifier: MIT
#version 460
#extension GL_GOOGLE_include_directive : require
#include "common.glsl"
layout(local_size_x = 1) in;
layout(binding = 0) uniform sampler2DShadow map;
layout(scalar, binding = 1) writeonly buffer To { float values[]; }
to;
layout(scalar, push_constant) uniform Push { vec3 place_and_depth; }
push;
void main() { to.values[0] = textureLod(map, push.place_and_depth, 0.0); }
