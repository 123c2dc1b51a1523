// SPDX-License-Identifier: MIT
#include "reference/regions.h"

#include "api/reference_view.h"
#include "dermis/reference.h"

namespace dermis {

std::vector<PictureRegion> picture_regions(const Scene& scene, const RenderSettings& settings) {
  const reference::View view = api::reference_view(scene.data(), settings);
  const rays::RayScene rays(scene.data());
  std::vector<PictureRegion> out;
  for (reference::Region& region : reference::regions(rays, view))
    out.push_back({.name = std::move(region.name), .mask = std::move(region.mask), .pixels = region.pixels});
  return out;
}

}  // namespace dermis
