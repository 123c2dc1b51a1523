// SPDX-License-Identifier: MIT
/// How much of the sky each point of the skin sees, and where it opens: what darkens nostrils, eye sockets and the fold behind an ear.
/// Based on: Landis: Production-Ready Global Illumination. SIGGRAPH 2002 course 16 (bent normals).
#pragma once

#include <cstdint>
#include <filesystem>
#include <memory>
#include <vector>

#include "scene/unwrap.h"

namespace dermis::environment {

/// Of one skin mesh, over its unwrap. Rows from top to bottom.
struct Occlusion {
  int side = 0;  ///< texels
  /// side * side * 4: the mean direction in which the sky is seen less the normal (0 where nothing is in the way), and the share of the
  /// hemisphere that is seen, weighted by the cosine, 0..1. Texels off the mesh continue those beside it for some texels, then hold 0 0
  /// 0 1.
  std::vector<float> values;
};

struct OcclusionSettings {
  int side = 512;  ///< 16 .. 4096
  int rays = 96;   ///< a texel, 1 .. 65536
};

/// Everything opaque in the scene is in the way, cut-outs (lashes, hair cards) are not. The result does not depend on the number of
/// threads.
Occlusion bake_occlusion(const scene::Scene& scene, const scene::SkinMesh& mesh, const OcclusionSettings& settings = {});

/// The same through a cache of files in `folder` (none if empty): named by a hash of all that it depends on, checked when read. A cache
/// that cannot be read or written costs time, with a warning, and nothing else.
Occlusion cached_occlusion(const scene::Scene& scene, const scene::SkinMesh& mesh, const std::filesystem::path& folder,
                           const OcclusionSettings& settings = {});

}  // namespace dermis::environment
