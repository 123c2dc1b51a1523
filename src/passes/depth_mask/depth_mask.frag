// SPDX-License-Identifier: MIT
#version 460
layout(binding = 0) uniform sampler2D light;
void main() {
  if (texelFetch(light, ivec2(gl_FragCoord.xy), 0).a == 0.0) discard;
  gl_FragDepth = 1.0;
}
