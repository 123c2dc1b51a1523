// SPDX-License-Identifier: MIT
/// Options of files and arrays that become assets.
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "dermis/scene.h"

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

}  // namespace dermis::scene
