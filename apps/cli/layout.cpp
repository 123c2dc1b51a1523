// SPDX-License-Identifier: MIT
#include "cli/layout.h"

#include "base/core/error.h"

namespace dermis::cli {

Scene laid_out(const std::vector<Asset>& assets, Layout layout) {
  std::vector<AssetBounds> bounds;
  std::vector<double> radii_m;
  for (const Asset& asset : assets) {
    bounds.push_back(asset.bounds());
    radii_m.push_back(bounds.back().radius_m);
  }

  const std::vector<std::array<double, 2>> places = places_m(layout, radii_m);
  const std::array<double, 3> middle = bounds.at(assets.size() / 2).centre_m;
  Scene scene;
  for (std::size_t i = 0; i < assets.size(); ++i) {
    Instance instance{.asset = assets[i], .name = assets[i].name()};
    for (std::size_t axis = 0; axis < 3; ++axis) {
      const double to_place = axis < 2 ? places[i][axis] : 0;
      instance.world_from_asset[12 + axis] = middle[axis] - bounds[i].centre_m[axis] + to_place;
    }
    scene.add(instance);
  }
  return scene;
}

}  // namespace dermis::cli
