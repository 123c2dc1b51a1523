// SPDX-License-Identifier: MIT
/// How a light's shadow map is fitted to a head: all of its texels on the head's bounding sphere.
#pragma once

#include <glm/glm.hpp>
#include <vector>

#include "scene/scene.h"

namespace dermis::passes {

struct ShadowFit {
  /// 1, or 6 (+x -x +y -y +z -z) for a light inside the sphere; reversed depth 0..1
  std::vector<glm::mat4> shadow_from_world;
  /// side of a texel: metres (directional), or metres per metre of distance
  float texel = 0;
};

/// A light outside the sphere sees it in one perspective layer that just holds it; one inside needs six.
/// map_size in texels.
ShadowFit fit_shadow(const scene::Light& light, const scene::BoundingSphere& sphere, int map_size);

}  // namespace dermis::passes
