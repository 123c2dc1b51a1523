// SPDX-License-Identifier: MIT
// One triangle that covers the viewport, for each sample.
#version 460
layout(location = 0) flat out int out_sample;
void main() {
  out_sample = gl_InstanceIndex;
  gl_Position = vec4(vec2(gl_VertexIndex & 1, gl_VertexIndex >> 1) * 4.0 - 1.0, 0.5, 1.0);
}
