// SPDX-License-Identifier: MIT
// From the coordinates of an asset to the world. An instance that is not turned moves its points by one
// addition, exactly: products with 0 and 1 do not round.
#include "shared/instance_io.h"
layout(binding = 33, scalar) uniform Instance { InstanceIo instance; };

vec3 world_direction(vec3 d) { return instance.x_axis * d.x + instance.y_axis * d.y + instance.z_axis * d.z; }

vec3 world_position(vec3 position_m) {
  return world_direction(position_m) * instance.scale + instance.origin_m;
}
