// SPDX-License-Identifier: MIT
/// A scene, whatever the settings: its skin as meshes with an unwrap, bounds, densities. Made once per scene.
#pragma once

#include <memory>
#include <vector>

#include "head/scene/asset_data.h"
#include "head/scene/framing.h"
#include "head/scene/surface/unwrap.h"

namespace dermis::setup {

struct Subject {
  std::shared_ptr<const scene::AssetData> scene;
  std::vector<scene::SkinMesh> skin;
  std::vector<scene::UnwrapDensity> densities;  ///< one per skin mesh
  scene::Bounds bounds;                         ///< of the skin
  scene::BoundingSphere casters;                ///< of everything: hair cards and collars cast shadows too
  std::vector<glm::vec3> caster_corners_m;      ///< scene::enclosing_corners() of the same
};

/// Throws InputError: a scene with nothing to see. Warns of unwraps that overlap.
Subject examine(std::shared_ptr<const scene::AssetData> scene);

}  // namespace dermis::setup
