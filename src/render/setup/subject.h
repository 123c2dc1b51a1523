// SPDX-License-Identifier: MIT
/// An asset as frames need it, whatever their settings: its skin as meshes with an unwrap, bounds, densities.
#pragma once

#include <memory>
#include <vector>

#include "head/scene/asset_data.h"
#include "head/scene/framing.h"
#include "head/scene/surface/unwrap.h"

namespace dermis::setup {

struct Subject {
  std::shared_ptr<const scene::AssetData> asset;
  std::vector<scene::SkinMesh> skin;
  std::vector<scene::UnwrapDensity> densities;  ///< one per skin mesh
  scene::Bounds bounds;                         ///< of the skin
  scene::BoundingSphere casters;                ///< of everything: hair cards and collars cast shadows too
  std::vector<glm::vec3> caster_corners_m;      ///< scene::enclosing_corners() of the same
};

using SubjectPointer = std::shared_ptr<const Subject>;

/// Throws InputError: an asset with nothing to see. Warns of unwraps that overlap.
SubjectPointer examine(std::shared_ptr<const scene::AssetData> asset);

}  // namespace dermis::setup
