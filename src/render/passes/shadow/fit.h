// SPDX-License-Identifier: MIT
/// Fits a light's shadow map to the outline of a head as the light sees it, so that all its texels lie there.
#pragma once

#include <glm/glm.hpp>
#include <span>
#include <vector>

#include "head/scene/asset_data.h"

namespace dermis::passes {

struct ShadowFit {
  /// 1, or 6 (+x -x +y -y +z -z) for a light inside the sphere; reversed depth 0..1
  std::vector<glm::mat4> shadow_from_world;
  /// side of a texel: metres (directional), or metres per metre of distance
  float texel = 0;
};

/// A body that casts a shadow, in the world.
struct ShadowBounds {
  scene::BoundingSphere sphere;
  /// Of a convex body that holds all of it, such as scene::enclosing_corners(); none: only the sphere is
  /// known.
  std::span<const glm::vec3> corners_m;
  /// The same as it was loaded, of what moves from frame to frame.
  const ShadowBounds* rest = nullptr;
};

/// Returns one layer that holds what casts a shadow, as tight as corners or sphere say, for a light outside
/// the sphere; six layers for a light inside. side: of the map, texels. A body that moves has its texels
/// where those of its rest lie, with sides by steps of 4.4 %. From frame to frame the map shifts by whole
/// texels, and seldom changes its size, so that edges of shadows do not crawl.
ShadowFit fit_shadow(const scene::Light& light, const ShadowBounds& bounds, int side);

}  // namespace dermis::passes
