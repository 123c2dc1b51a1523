// SPDX-License-Identifier: MIT
// The frame, and where a point lies as its camera sees it.
#include "render/shaders/clip.glsl"
layout(binding = 3, scalar) uniform Frame { FrameIo frame; };

// Returns the vector from a point to the eye; of unit length if the camera is orthographic.
vec3 to_eye(vec3 position_m) {
  return frame.camera.orthographic != 0u ? -frame.camera.direction : frame.camera.eye_m - position_m;
}

vec4 clip_position(vec3 world_m) { return clip_position(frame.camera.clip_from_world, world_m); }

// Returns how far inside the margin of a plane of the picture a point lies, metres: below 0, light maps leave
// it out ([JG08] sec. 5).
float distance_inside(int plane, vec3 position_m) {
  const vec4 p = frame.camera.planes[plane];
  return dot(p.xyz, position_m) + (p.w + frame.clip_margin_m);
}
