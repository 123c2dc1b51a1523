// SPDX-License-Identifier: MIT
// Returns clip coordinates. Precise: passes that test against each other's depth must agree on its last bit,
// and drivers merge products and sums differently from shader to shader.
vec4 clip_position(mat4 clip_from_world, vec3 world_m) {
  precise const vec4 clip = clip_from_world * vec4(world_m, 1.0);
  return clip;
}
