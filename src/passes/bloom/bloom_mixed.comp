// SPDX-License-Identifier: MIT
#version 460
layout(binding = 1) uniform sampler2D smaller;
vec3 mixed(vec3 light, ivec2 p);
#include "passes/bloom/bloom.glsl"

vec3 mixed(vec3 light, ivec2 p) {
  const vec2 at = (vec2(p) + 0.5) / float(1u << io.halvings);  // halving may reach over the last pixel
  return mix(light, textureLod(smaller, at / vec2(textureSize(smaller, 0)), 0.0).rgb, io.share);
}
