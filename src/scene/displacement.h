// SPDX-License-Identifier: MIT
// Height maps become fine normals: pores need no triangles.
#pragma once

#include <glm/glm.hpp>

#include "image/image.h"
#include "scene/scene.h"
#include "scene/unwrap.h"

namespace dermis::scene {

struct DisplacementSettings {
  /// black to white; may be negative. Which value is zero height makes no difference to normals
  double displacement_mm = 0;
  int channel = 0;  ///< of the height map, 0 .. 3
  /// mm per unit of the maps' coordinates, along the tangent and across it (mean_mm_per_uv); > 0
  glm::dvec2 mm_per_uv{300, 300};
  Wrap wrap_u = Wrap::repeat, wrap_v = Wrap::repeat;
  /// normal scale of the base map; the result holds it, so use the result with scale 1
  double base_scale = 1;
  /// Both maps describe the same skin: where the base map is the coarser one, take from the heights only what
  /// is finer than its texels, or every wrinkle that both hold would count twice (on the scan their slopes
  /// correlate with 0.3). False: add all.
  bool only_finer_than_base = true;
};

inline constexpr int max_normal_map_side = 4096;

/// Standard deviation in texels of the heights of the Gaussian that goes before the derivative. 8-bit heights
/// are stairs: rounding to steps of q mm puts noise of q / sqrt(12) on every height, and its slope, q /
/// (sqrt(12) * spacing * sqrt(8 pi) * sigma^2) behind a Gaussian, would show as glittering terraces. sigma
/// brings it down to half a degree; at least 0.7 (derivatives of undersampled heights alias), at most 2
/// (pores are a few texels wide and must survive).
double height_smoothing_texels(double displacement_mm, double mm_per_texel);

/// Tangent-space normals, +Y up (towards -v), RGBA8 with alpha 255, of the heights laid over `base` (null: a
/// flat one). Slopes add, since heights do ("partial derivative blending"): n = normalize(-dh/du + bx/bz,
/// +dh/dv + by/bz, 1), lengths in mm. Size: per axis the larger of both maps, at most 4096. Both must be read
/// with the same coordinates and transform. The metric enters by its mean: where skin is stretched more than
/// on average, pores come out too steep by as much.
image::Image8 displaced_normals(const image::Image8& heights, const DisplacementSettings& settings,
                                const image::Image8* base = nullptr);

/// Mean over the skin's area (harmonic, as slopes go with the inverse) of mm per unit of unwrap along dP/du
/// and square to it. For a map read through a transform divide by the length of its columns. (300, 300) if no
/// triangle is valid.
glm::dvec2 mean_mm_per_uv(const SkinMesh& mesh, double mm_per_unit);

}  // namespace dermis::scene
