// SPDX-License-Identifier: MIT
/// The sky from each point of the skin: visibility, bent normal, and transfer of light from there. Darkens
/// nostrils, eye sockets and the fold behind an ear, and the side of a nose that faces away from a window.
/// Based on: [L02] Landis: Production-Ready Global Illumination. SIGGRAPH 2002 course 16 (bent normals)
/// [SKS02] Sloan, Kautz, Snyder: Precomputed Radiance Transfer. SIGGRAPH 2002 (shadowed and interreflected
///         diffuse transfer)
#pragma once

#include <cstdint>
#include <filesystem>
#include <memory>
#include <vector>

#include "environment/harmonics.h"
#include "head/scene/surface/unwrap.h"

namespace dermis::environment {

/// Occlusion of one skin mesh, over its unwrap. Rows from top to bottom.
struct Occlusion {
  int side = 0;  ///< texels
  /// side * side * 4: bent normal minus normal (0 if nothing occludes), and the visible share of the
  /// hemisphere, weighted by the cosine, 0..1. Texels off the mesh repeat their neighbours for some texels,
  /// then hold 0 0 0 1.
  std::vector<float> values;
  /// side * side * harmonic_terms half floats: transfer of the visible sky, Int V cos Y. Its product with the
  /// harmonics of radiance is irradiance.
  std::vector<std::uint16_t> transfer;
  /// side * side * bounced_terms half floats: transfer of the sky light that white occluders reflect once, up
  /// to order 3, divided by the mean visible share of these occluders. Then that share.
  std::vector<std::uint16_t> bounced;
};
inline constexpr std::size_t bounced_terms = 16 + 1;

struct OcclusionSettings {
  int side = 512;  ///< 16 .. 4096
  int rays = 96;   ///< per texel, 1 .. 65536
};

/// Returns the side [texels] of the map of one mesh, given the number of skin meshes: 512 for up to four,
/// then smaller, down to 64. So all together have no more texels than four maps of 512.
int occlusion_side(std::size_t meshes);

/// Bakes the occlusion of a mesh. Occluders are opaque materials and what the alpha test leaves of cut-out
/// ones; blended parts (lashes, brows) are none. The result does not depend on the number of threads. Counts
/// steps (base/core/hooks.h): takes seconds, and throws Cancelled if its caller ends it.
Occlusion bake_occlusion(const scene::AssetData& scene, const scene::SkinMesh& mesh,
                         const OcclusionSettings& settings = {});

/// Bakes, or reads the result from a file in `folder` (no files if empty; see base/core/cache.h), named by a
/// hash of all that it depends on. Writes nothing if cancelled.
Occlusion cached_occlusion(const scene::AssetData& scene, const scene::SkinMesh& mesh,
                           const std::filesystem::path& folder, const OcclusionSettings& settings = {});

/// Irradiance per texel, side * side * 4 values, RGB never negative.
struct SkyLight {
  std::vector<float> direct;  ///< from the visible sky; alpha is 1
  /// From occluders, as if they were white and saw the same share m of the sky at each further bounce; alpha
  /// is m. Irradiance B with albedo a adds B a m / (1 - a (1 - m)).
  std::vector<float> bounced;
};
/// Returns the light on each texel: `sky` is seen directly, `bounced_sky` lights the occluders.
SkyLight sky_light(const Occlusion& occlusion, const SkyHarmonics& sky, const SkyHarmonics& bounced_sky);

}  // namespace dermis::environment
