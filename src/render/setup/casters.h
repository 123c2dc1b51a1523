// SPDX-License-Identifier: MIT
/// Bodies to which shadow maps of a head are fitted.
#pragma once

#include <glm/glm.hpp>
#include <optional>
#include <vector>

#include "head/scene/asset_data.h"
#include "render/passes/shadow/fit.h"
#include "render/setup/placed_scene.h"

namespace dermis::setup {

/// Bodies that cast the shadows of a head, in the world.
class Casters {
 public:
  /// `posed`: of a head in a pose, else null. `deformed`: a host moves its vertices, which may leave the body
  /// between the corners; only its sphere is known.
  Casters(const scene::AssetData& asset, const PosedAsset* posed, const scene::Similarity& world_from_asset,
          bool deformed = false);
  Casters(const Casters&) = delete;
  Casters& operator=(const Casters&) = delete;

  /// Lives as long as this.
  passes::ShadowBounds bounds() const { return {sphere_, corners_m_, rest_ ? &*rest_ : nullptr}; }

 private:
  std::vector<glm::vec3> rest_corners_m_, corners_m_;
  std::optional<passes::ShadowBounds> rest_;  ///< of what moves
  scene::BoundingSphere sphere_;
};

}  // namespace dermis::setup
