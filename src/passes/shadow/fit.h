// SPDX-License-Identifier: MIT
/// Fits a light's shadow map to the bounding sphere of a head, so that all its texels lie there.
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

/// Returns one perspective layer that just holds the sphere for a light outside it, six layers for a light
/// inside. map_size in texels.
ShadowFit fit_shadow(const scene::Light& light, const scene::BoundingSphere& sphere, int map_size);

}  // namespace dermis::passes
