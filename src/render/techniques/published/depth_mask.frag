// SPDX-License-Identifier: MIT
// [JG08] sec. 3, the other way to skip unlit texels. Depth is 1 where there is
// light and 0 elsewhere, so that convolutions drawn at a depth of 0.5 are rejected before they start.
#version 460
layout(binding = 0, rgba16f) uniform readonly image2D light;
void main() {
  if (imageLoad(light, ivec2(gl_FragCoord.xy)).a == 0.0) discard;
  gl_FragDepth = 1.0;
}
