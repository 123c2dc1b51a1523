// SPDX-License-Identifier: MIT
#include "cli/layout.h"

#include "api/asset_state.h"
#include "core/error.h"
#include "scene/framing.h"

namespace dermis::cli {

Scene laid_out(const std::vector<Asset>& assets, Layout layout) {
  std::vector<scene::BoundingSphere> spheres;
  std::vector<double> radii_m;
  for (const Asset& asset : assets) {
    spheres.push_back(scene::skin_sphere(*Asset::State::of(asset)));
    radii_m.push_back(double{spheres.back().radius_m});
  }

  const std::vector<std::array<double, 2>> places = places_m(layout, radii_m);
  const glm::dvec3 middle(spheres.at(assets.size() / 2).centre_m);
  Scene scene;
  for (std::size_t i = 0; i < assets.size(); ++i) {
    Instance instance{.asset = assets[i], .name = assets[i].name()};
    const glm::dvec3 shift = middle - glm::dvec3(spheres[i].centre_m);
    instance.world_from_asset[12] = shift.x + places[i][0];
    instance.world_from_asset[13] = shift.y + places[i][1];
    instance.world_from_asset[14] = shift.z;
    scene.add(instance);
  }
  return scene;
}

}  // namespace dermis::cli
