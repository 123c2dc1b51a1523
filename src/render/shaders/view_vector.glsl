// SPDX-License-Identifier: MIT
// Returns the unit vector from a point to the camera. Needs frame.glsl and switches.glsl.
vec3 view_vector(vec3 position_m) {
  return is_on(frame.camera.orthographic) ? -frame.camera.direction
                                          : normalize(frame.camera.eye_m - position_m);
}
