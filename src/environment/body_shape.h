// SPDX-License-Identifier: MIT
/// The shape of the body around each vertex of the skin: what changes how much light leaves it
/// (tissue/profile/shape_laws.h). Curvature comes from head/scene/surface/curvature.h, thickness from rays
/// into the body. Based on: [SSC08] Shapira, Shamir, Cohen-Or: Consistent Mesh Partitioning and
/// Skeletonisation using the Shape
///           Diameter Function. The Visual Computer 24, 2008 (rays into a cone around the inward normal)
#pragma once

#include <filesystem>
#include <vector>

#include "head/scene/surface/curvature.h"
#include "head/scene/surface/unwrap.h"

namespace dermis::environment {

inline constexpr float most_thickness_mm = 50;  ///< at most
inline constexpr float most_border_mm = 20;     ///< at most

/// The scales at which curvature is taken. The effect of a bump on light falls with the bump's size as the
/// profile does, narrow and wide; docs/accuracy.md ("Skin that knows its shape") compares scales.
inline constexpr scene::CurvatureScales curvature_scales{.narrow_mm = 2.5, .wide_mm = 8};

/// Finds the shape at each vertex of a mesh. Convex curvature counts by the share of the directions around
/// the normal that no other skin closes within 6 mm. The law holds for light that leaves into the open; by it
/// alone the convex rims of closed lids and lips would shine.
///
/// The result does not depend on the number of threads. Counts
/// steps (base/core/hooks.h): takes up to a second, and throws Cancelled if its caller ends it.
std::vector<scene::VertexShape> body_shape(const scene::AssetData& scene, const scene::SkinMesh& mesh);

/// The same, or from a file in `folder` (none if empty; see base/core/cache.h), named by a hash of all that
/// it depends on. Writes nothing if cancelled.
std::vector<scene::VertexShape> cached_body_shape(const scene::AssetData& scene, const scene::SkinMesh& mesh,
                                                  const std::filesystem::path& folder);

}  // namespace dermis::environment
