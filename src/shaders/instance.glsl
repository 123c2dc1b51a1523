// SPDX-License-Identifier: MIT
// From the coordinates of an asset to the world. An instance that is not turned moves its points by one
// addition, exactly: products with 0 and 1 do not round. Precise as clip_position() is.
#ifndef INSTANCE  // a pass may have it elsewhere
#include "shaders/head.glsl"
#define INSTANCE of_head.instance
#endif

vec3 world_direction(vec3 d) { return INSTANCE.x_axis * d.x + INSTANCE.y_axis * d.y + INSTANCE.z_axis * d.z; }

vec3 world_position(vec3 position_m) {
  precise const vec3 turned =
      INSTANCE.x_axis * position_m.x + INSTANCE.y_axis * position_m.y + INSTANCE.z_axis * position_m.z;
  precise const vec3 world_m = turned * INSTANCE.scale + INSTANCE.origin_m;
  return world_m;
}
