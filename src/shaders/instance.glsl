// SPDX-License-Identifier: MIT
// From the coordinates of an asset to the world. An instance that is not turned moves its points by one
// addition, exactly: products with 0 and 1 do not round.
#ifndef INSTANCE  // a pass may have it elsewhere
#include "shaders/head.glsl"
#define INSTANCE of_head.instance
#endif

vec3 world_direction(vec3 d) { return INSTANCE.x_axis * d.x + INSTANCE.y_axis * d.y + INSTANCE.z_axis * d.z; }

vec3 world_position(vec3 position_m) {
  return world_direction(position_m) * INSTANCE.scale + INSTANCE.origin_m;
}
