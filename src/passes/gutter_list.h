// SPDX-License-Identifier: MIT
/// The gutters of a mesh as the device needs them.
#pragma once

#include <cstdint>
#include <glm/glm.hpp>
#include <vector>

#include "scene/gutters.h"

namespace dermis::passes {

struct GutterList {
  /// scene::build_gutters, and behind them each texel within two of a chart that nothing fills (the corners
  /// where several seams meet): it takes the nearest texel's light, with chart 0, so that no bilinear read at
  /// a rim finds black.
  std::vector<scene::GutterTexel> texels;
  /// For each the nearest texel of the chart that it extends: its metric goes on there. Itself where its
  /// chart has no texel within 128, or it extends none.
  std::vector<glm::uvec2> own;
};

GutterList gutter_list(const scene::SkinMesh& mesh, int map_size, int width_texels);

}  // namespace dermis::passes
