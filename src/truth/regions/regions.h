// SPDX-License-Identifier: MIT
// Parts of a picture in which techniques differ from the truth for different reasons, found from the scene
// itself.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "rays/ray_scene.h"
#include "truth/reference/settings.h"

namespace dermis::regions {

/// Pixels, row by row; 0 = not in the region.
struct Region {
  std::string name;
  std::vector<std::uint8_t> mask;
  std::size_t pixels = 0;  ///< that are not 0
};

/// Of the pixels whose middle shows skin, in this order; all but the first and the last may overlap, and any
/// may be empty:
///   skin          all of them
///   ears, nose    by shape, see HeadFrame; empty where the skin is no head that looks along +Z
///   terminator    the surface turns away from a light: |cos| of their angle under 0.2, and lit skin
///                 beside it
///   shadow edges  within 5 mm of where the shadow of something else begins or ends on skin that faces
///                 the light
///   thin parts    under 10 mm thick (thickness_m): light comes through
///   folds         within 3 mm of where other skin is less than 5 mm away in the open (gap_m): closed lids,
///                 lips, nostrils
///   seams         within 3 mm of where the unwrap is cut
///   the rest      skin in none of these
/// Distances are straight lines between points that the picture shows. Lights without light do not count;
/// parts that are cut out by a map (alpha mode mask) cast no shadow here.
std::vector<Region> find(const rays::RayScene& rays, const reference::RenderSetup& setup);

}  // namespace dermis::regions
