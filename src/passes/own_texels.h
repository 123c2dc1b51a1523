// SPDX-License-Identifier: MIT
/// For each gutter texel the nearest texel of the chart that it extends: its metric goes on there.
#pragma once

#include <cstdint>
#include <glm/glm.hpp>
#include <span>
#include <vector>

#include "scene/gutters.h"

namespace dermis::passes {

/// One a gutter texel, itself where its chart has no texel within 128 (or it extends none).
std::vector<glm::uvec2> own_texels(const scene::SkinMesh& mesh, std::span<const scene::GutterTexel> gutters, int map_size);

}  // namespace dermis::passes
