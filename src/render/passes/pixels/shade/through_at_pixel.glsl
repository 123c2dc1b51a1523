// SPDX-License-Identifier: MIT
// Transmitted light where no term is read from a map.
#include "render/shaders/skin_through.glsl"

// Returns sum_i w_i T_i: terms of a group share their mean, as in light maps.
vec3 all_through(LitThrough r) {
  vec3 sum = vec3(0.0), mean = vec3(0.0);
  for (int g = 0; g < TRANSMISSION_GROUPS; ++g) {
    mean += joining(r, g);
    sum += transmission.group_weight[g] * mean;
  }
  return sum;
}
