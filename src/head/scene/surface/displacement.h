// SPDX-License-Identifier: MIT
// Converts height maps to normal maps, so that pores need no triangles.
#pragma once

#include <glm/glm.hpp>

#include "head/scene/asset_data.h"
#include "head/scene/surface/unwrap.h"
#include "image/image.h"

namespace dermis::scene {

struct DisplacementSettings {
  /// from black to white; may be negative. The value of zero height does not affect normals
  double displacement_mm = 0;
  int channel = 0;  ///< in the height map, 0 .. 3
  /// mm per unit of the maps' coordinates, along the tangent and across (mean_mm_per_uv); > 0
  glm::dvec2 mm_per_uv{300, 300};
  AssetWrap wrap_u = AssetWrap::repeat, wrap_v = AssetWrap::repeat;
  /// normal scale of the base map; the result includes it, so use the result with scale 1
  double base_scale = 1;
};

inline constexpr int max_normal_map_side = 4096;

/// Returns the standard deviation [texels] of the Gaussian that smooths heights before the derivative, 0.7 to
/// 2. Heights have steps, those of 8 bits large ones, whose slopes would show as glittering terraces; the
/// Gaussian reduces their noise to half a degree. Below 0.7 derivatives of undersampled heights alias; above
/// 2 pores, a few texels wide, would vanish.
double height_smoothing_texels(double step_mm, double mm_per_texel);

/// Returns tangent-space normals, +Y up (towards -v), RGBA8 with alpha 255, of the heights on top of `base`
/// (null: flat). Where the base is coarser, it takes from the heights only detail finer than its texels. Both
/// maps describe the same skin, and wrinkles in both would count twice (on the scan their slopes correlate
/// with 0.3). Size: per axis the larger of both maps, at most 4096. Both maps use the same coordinates and
/// transform. Uses the mean metric: where skin is stretched more than average, pores are too steep by this
/// factor.
image::Image8 displaced_normals(const image::Image8& heights, const DisplacementSettings& settings,
                                const image::Image8* base = nullptr);

/// Returns mm per unit of unwrap along dP/du and perpendicular to it: the harmonic mean over the skin's area,
/// because slopes go with the inverse. For a map with a transform, divide by the length of its columns. (300,
/// 300) if no triangle is valid.
glm::dvec2 mean_mm_per_uv(const SkinMesh& mesh, double mm_per_unit);

}  // namespace dermis::scene
