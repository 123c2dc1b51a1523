// SPDX-License-Identifier: MIT
#include "head/scene/surface/measured.h"

#include <utility>

#include "base/core/hooks.h"
#include "head/scene/framing.h"
#include "head/scene/surface/coverage.h"
#include "head/scene/surface/enclosure.h"
#include "head/scene/surface/unwrap.h"

namespace dermis::scene {

std::shared_ptr<const AssetData> measured(AssetData asset) {
  asset.skin = skin_meshes(asset);
  Steps steps("measuring the unwrap", asset.skin.size());
  for (SkinMesh& mesh : asset.skin) {
    mesh.density = unwrap_density(mesh, asset.mm_per_unit);
    mesh.overlap = uv_overlap_fraction(mesh);
    steps.done();
  }

  asset.bounds = skin_bounds(asset);
  asset.casters = bounding_sphere(asset, [](const Primitive&) { return true; });
  asset.caster_corners_m = enclosing_corners(asset);
  return std::make_shared<const AssetData>(std::move(asset));
}

}  // namespace dermis::scene
