// SPDX-License-Identifier: MIT
// Where the picture of the environment has a direction. Needs `frame`, pi.

// The environment is turned about +Y, so directions are turned back.
vec3 environment_frame(vec3 d) {
  return vec3(d.x * frame.environment_cos - d.z * frame.environment_sin, d.y,
              d.x * frame.environment_sin + d.z * frame.environment_cos);
}

// Returns the place of a direction of the environment, 0..1, v down.
vec2 environment_place(vec3 d) {
  return vec2(0.5 + atan(d.x, -d.z) / (2.0 * pi), acos(clamp(d.y, -1.0, 1.0)) / pi);
}
