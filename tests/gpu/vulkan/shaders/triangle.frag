// SPDX-License-Identifier: MIT
#version 460
#extension GL_GOOGLE_include_directive : require
#include "common.glsl"
layout(constant_id = 1) const float gain = 1.0;
layout(location = 0) in vec4 colour;
layout(location = 0) out vec4 result;
layout(scalar, binding = 2) uniform Tint { vec4 factor; }
tint;
void main() { result = colour * gain * tint.factor; }
