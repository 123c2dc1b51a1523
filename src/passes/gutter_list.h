// SPDX-License-Identifier: MIT
/// What the device needs to know of gutters beside their list.
#pragma once

#include <cstdint>
#include <glm/glm.hpp>
#include <span>
#include <vector>

#include "scene/gutters.h"

namespace dermis::passes {

/// The gutters of a mesh, and behind them each texel within two of a chart that nothing fills (the corners where several seams meet): it
/// takes the nearest texel's light, with chart 0, so that no bilinear read at a rim finds black.
std::vector<scene::GutterTexel> complete_gutters(const scene::SkinMesh& mesh, int map_size, int width_texels);

/// For each gutter texel the nearest texel of the chart that it extends: its metric goes on there. Itself where its chart has no texel
/// within 128, or it extends none.
std::vector<glm::uvec2> own_texels(const scene::SkinMesh& mesh, std::span<const scene::GutterTexel> gutters, int map_size);

}  // namespace dermis::passes
