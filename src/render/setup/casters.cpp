// SPDX-License-Identifier: MIT
#include "render/setup/casters.h"

#include <algorithm>
#include <iterator>

namespace dermis::setup {
namespace {

std::vector<glm::vec3> placed(const std::vector<glm::vec3>& points_m,
                              const scene::Similarity& world_from_asset) {
  std::vector<glm::vec3> out;
  out.reserve(points_m.size());
  std::transform(points_m.begin(), points_m.end(), std::back_inserter(out),
                 [&](const glm::vec3& p_m) { return world_from_asset.position(p_m); });
  return out;
}

}  // namespace

Casters::Casters(const scene::AssetData& asset, const PosedAsset* posed,
                 const scene::Similarity& world_from_asset, bool deformed)
    : sphere_(world_from_asset.sphere(posed ? posed->all.sphere : asset.casters)) {
  if (deformed) return;
  if (!posed) {
    corners_m_ = placed(asset.caster_corners_m, world_from_asset);
    return;
  }

  corners_m_ = placed(posed->corners_m, world_from_asset);
  if (corners_m_.empty()) return;
  rest_corners_m_ = placed(asset.caster_corners_m, world_from_asset);
  rest_ = {world_from_asset.sphere(asset.casters), rest_corners_m_};
}

}  // namespace dermis::setup
