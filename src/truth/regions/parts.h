// SPDX-License-Identifier: MIT
// Nose and ears at the vertices of skin, once for each asset, so that a picture can name them without rays.
#pragma once

#include <glm/glm.hpp>
#include <span>
#include <vector>

#include "head/scene/asset_data.h"
#include "head/scene/surface/unwrap.h"

namespace dermis::regions {

/// Returns, for each vertex of each mesh, its distance inside the nose (x) and inside an ear (y), in half
/// breadths of the head, negative outside. Both are -1 where the skin is no head that looks along +Z in its
/// own coordinates. `skin`: skin_meshes() of the scene.
///
/// The same nose and ears as those of regions::find(), but the thickness is taken in the middle of each
/// triangle rather than at pixels. So the border of an ear is as exact as the triangles there are small, and
/// the ear has thin skin that no picture shows. Takes 24 rays per triangle beside the head. Throws
/// DeviceError and Cancelled as rays::RayScene does.
std::vector<std::vector<glm::vec2>> parts_of_skin(const scene::AssetData& scene,
                                                  std::span<const scene::SkinMesh> skin);

}  // namespace dermis::regions
