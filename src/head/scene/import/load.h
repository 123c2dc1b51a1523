// SPDX-License-Identifier: MIT
// Loads scenes. Every limit is checked before memory is taken; any fault ends in one InputError that names
// file and place.
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "dermis/scene.h"
#include "head/scene/asset_data.h"

namespace dermis::scene {

struct LoadOptions {
  double unit_scale = SceneOptions().unit_scale;  ///< as SceneOptions, which are checked where they are given
  std::vector<std::string> skin_material;         ///< as SceneOptions
  std::string clip;                               ///< as SceneOptions
  std::optional<double> time_s;                   ///< as SceneOptions
  std::size_t max_triangles = 20'000'000;
  int max_map_side = 16384;                                     ///< pixels
  double texture_budget_mb = SceneOptions().texture_budget_mb;  ///< as SceneOptions
};

/// Loads glTF 2.0, .gltf or .glb. Makes missing normals and tangents (head/scene/surface/tangents.h). Warns
/// (base/core/log.h) and counts steps (base/core/hooks.h): throws Cancelled if its caller ends it.
AssetData load_gltf(const std::filesystem::path& path, const LoadOptions& options = {});

}  // namespace dermis::scene
