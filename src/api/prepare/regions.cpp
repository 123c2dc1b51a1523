// SPDX-License-Identifier: MIT
#include "truth/regions/regions.h"

#include "api/prepare/reference_setup.h"
#include "api/scene_state.h"
#include "base/core/hooks.h"
#include "dermis/reference.h"

namespace dermis {

std::vector<PictureRegion> picture_regions(const Scene& scene, const RenderSettings& settings,
                                           const Hooks& hooks) {
  const HookScope scope(hooks);
  const setup::PlacedScene placed = api::placed_scene(scene);
  const reference::RenderSetup setup = api::reference_setup(placed, settings);
  const std::shared_ptr<const scene::AssetData> flat = setup::flattened(placed);
  const rays::RayScene rays(*flat);
  std::vector<PictureRegion> out;
  for (regions::Region& region : regions::find(rays, setup))
    out.push_back({.name = std::move(region.name), .mask = std::move(region.mask), .pixels = region.pixels});
  return out;
}

}  // namespace dermis
