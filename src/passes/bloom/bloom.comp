// SPDX-License-Identifier: MIT
#version 460
vec3 mixed(vec3 light, ivec2 p) { return light; }
#include "passes/bloom/bloom.glsl"
