// SPDX-License-Identifier: MIT
#version 460
// A box without buffers: 12 triangles of the cube -1..1, stretched and placed.
layout(push_constant) uniform Push {
  mat4 clip_from_world;
  vec4 centre, half_size;
};
layout(location = 0) out vec3 normal;
layout(location = 1) out vec3 position;

void main() {
  const vec2 corners[6] = {vec2(-1, -1), vec2(1, -1), vec2(1, 1), vec2(-1, -1), vec2(1, 1), vec2(-1, 1)};
  const int face = gl_VertexIndex / 6, axis = face / 2;
  const float side = (face & 1) == 0 ? -1.0 : 1.0;
  const vec2 c = corners[gl_VertexIndex % 6];
  vec3 p, n = vec3(0.0);
  p[axis] = side;
  p[(axis + 1) % 3] = c.x * side;
  p[(axis + 2) % 3] = c.y;
  n[axis] = side;
  normal = n;  // boxes stand straight in the world
  position = centre.xyz + p * half_size.xyz;
  gl_Position = clip_from_world * vec4(position, 1.0);
}
