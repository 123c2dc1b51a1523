// SPDX-License-Identifier: MIT
/// What each point of the skin sees of the sky: how much, where it opens, and what light from there adds up
/// to. It darkens nostrils, eye sockets and the fold behind an ear, and the side of a nose that is turned
/// from a window. Based on: Landis: Production-Ready Global Illumination. SIGGRAPH 2002 course 16 (bent
/// normals); [SKS02] Sloan, Kautz, Snyder: Precomputed Radiance Transfer. SIGGRAPH 2002 (shadowed and
/// interreflected transfer, diffuse)
#pragma once

#include <atomic>
#include <cstdint>
#include <filesystem>
#include <functional>
#include <memory>
#include <vector>

#include "environment/harmonics.h"
#include "scene/unwrap.h"

namespace dermis::environment {

/// Of one skin mesh, over its unwrap. Rows from top to bottom.
struct Occlusion {
  int side = 0;  ///< texels
  /// side * side * 4: the mean direction in which the sky is seen less the normal (0 where nothing is in the
  /// way), and the share of the hemisphere that is seen, weighted by the cosine, 0..1. Texels off the mesh
  /// continue those beside it for some texels, then hold 0 0 0 1.
  std::vector<float> values;
  /// side * side * harmonic_terms half floats: the cosine lobe about the normal where the sky is seen, Int V
  /// cos Y. Its product with the harmonics of radiance is irradiance.
  std::vector<std::uint16_t> transfer;
  /// side * side * bounced_terms half floats: the same of what is hidden, lit by the sky as its blockers are,
  /// up to order 3, over the mean share of the sky that these see; then that share.
  std::vector<std::uint16_t> bounced;
};
inline constexpr std::size_t bounced_terms = 16 + 1;

struct OcclusionSettings {
  int side = 512;  ///< 16 .. 4096
  int rays = 96;   ///< a texel, 1 .. 65536
};

/// Texels of a side for one of so many skin meshes: 512 for up to four, then fewer, so that all together have
/// no more texels than four of those, down to 64.
int occlusion_side(std::size_t meshes);

/// Who watches a bake, which takes seconds; both may be empty.
struct BakeWatch {
  std::function<void(double share)> progress{};  ///< 0 to 1, rising; called by one thread at a time
  const std::atomic<bool>* stop = nullptr;       ///< set by another thread, a signal or `progress`: ends it
};

/// Everything opaque in the scene is in the way, cut-outs (lashes, hair cards) are not. The result does not
/// depend on the number of threads. Cancelled: stopped.
Occlusion bake_occlusion(const scene::Scene& scene, const scene::SkinMesh& mesh,
                         const OcclusionSettings& settings = {}, const BakeWatch& watch = {});

/// The same through files in `folder` (none if empty), see core/cache.h: named by a hash of all that it
/// depends on. Nothing is written if it is stopped.
Occlusion cached_occlusion(const scene::Scene& scene, const scene::SkinMesh& mesh,
                           const std::filesystem::path& folder, const OcclusionSettings& settings = {},
                           const BakeWatch& watch = {});

/// Irradiance on each texel. `sky` is seen directly, `bounced_sky` lights what hides it. Side * side * 4
/// values, RGB never negative.
struct SkyLight {
  std::vector<float> direct;   ///< from what it sees of the sky; and 1
  std::vector<float> bounced;  ///< from what hides the sky, as if that were white and saw as much of the sky
                               ///< as it does at each further bounce; and that share of the sky, m: albedo a
                               ///< makes of it B a m / (1 - a (1 - m))
};
SkyLight sky_light(const Occlusion& occlusion, const SkyHarmonics& sky, const SkyHarmonics& bounced_sky);

}  // namespace dermis::environment
