// SPDX-License-Identifier: MIT
#version 460

// Vertices of ImGui's lists: positions in the window, coordinates in a texture, colours of the display.
layout(location = 0) in vec2 position;
layout(location = 1) in vec2 uv;
layout(location = 2) in vec4 colour;
layout(location = 0) out vec2 out_uv;
layout(location = 1) out vec4 out_colour;

layout(push_constant) uniform Push {
  vec2 scale;
  vec2 shift;
};

void main() {
  out_uv = uv;
  out_colour = colour;
  gl_Position = vec4(position * scale + shift, 0, 1);
}
