// SPDX-License-Identifier: MIT
// The head of a draw or dispatch, and the way from the coordinates of its asset to the world. An instance
// that is not turned moves its points by one addition, exactly: products with 0 and 1 do not round. Precise
// as clip_position() is.
#ifndef WORLD_FROM_ASSET  // a pass may have it elsewhere
#include "render/shared/scene_io.h"
layout(binding = 33, scalar) uniform Head { HeadIo of_head; };
#define WORLD_FROM_ASSET of_head.world_from_asset
#endif

vec3 world_direction(vec3 d) {
  return WORLD_FROM_ASSET.x_axis * d.x + WORLD_FROM_ASSET.y_axis * d.y + WORLD_FROM_ASSET.z_axis * d.z;
}

vec3 world_position(SimilarityIo s, vec3 p) {
  precise const vec3 world_m = (s.x_axis * p.x + s.y_axis * p.y + s.z_axis * p.z) * s.scale + s.origin_m;
  return world_m;
}

vec3 world_position(vec3 position_m) { return world_position(WORLD_FROM_ASSET, position_m); }
