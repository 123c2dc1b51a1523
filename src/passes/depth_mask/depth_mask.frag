// SPDX-License-Identifier: MIT
#version 460
layout(binding = 0, rgba16f) uniform readonly image2D light;
void main() {
  if (imageLoad(light, ivec2(gl_FragCoord.xy)).a == 0.0) discard;
  gl_FragDepth = 1.0;
}
