// SPDX-License-Identifier: MIT
// Heads whose texture coordinates are odd in a way that real files are.
#pragma once

#include <functional>
#include <glm/glm.hpp>
#include <string>
#include <vector>

#include "dermis/settings.h"
#include "head/scene/asset_data.h"

namespace dermis::tests {

/// A picture that is cheap on a software driver: `side` pixels square, light maps of `map_size`.
RenderSettings tiny_settings(int side, int map_size);

/// The scene with uv' = factor * uv + offset on its skin. Maps are moved likewise, so they show the same.
scene::AssetData moved(scene::AssetData scene, const glm::dmat2& factor, const glm::dvec2& offset = {});

/// Gives each triangle of the skin vertices of its own and lets `change` set the coordinates of each.
scene::AssetData with_triangles(
    scene::AssetData scene, const std::function<void(std::size_t triangle, scene::Vertex* corners)>& change);

struct MadeUp {
  std::string name;
  scene::AssetData scene;
};

/// A sphere of 0.1 m with coordinates that are scaled, moved, flipped, sheared, collapsed, partly without
/// area or missing, torn apart, on top of each other, or far off.
std::vector<MadeUp> made_up_unwraps();

}  // namespace dermis::tests
