// SPDX-License-Identifier: MIT
// Clips skin outside the picture and its margin, although it is drawn in texture coordinates. [JG08] sec. 5.
// Follows frame.glsl.
out gl_PerVertex {
  vec4 gl_Position;
  float gl_ClipDistance[5];
};

void clip_to_picture(vec3 position_m) {
  for (int i = 0; i < 5; ++i) gl_ClipDistance[i] = distance_inside(i, position_m);
}
