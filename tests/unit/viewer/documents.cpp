// SPDX-License-Identifier: MIT
#include "unit/viewer/documents.h"

#include <array>
#include <memory>

#include "dermis/asset_arrays.h"

namespace dermis::tests {

viewer::Document square_document() {
  const std::array<std::array<float, 3>, 4> positions{
      {{-0.1f, 0.4f, 0}, {0.1f, 0.4f, 0}, {0.1f, 0.6f, 0}, {-0.1f, 0.6f, 0}}};
  const std::array<std::array<float, 2>, 4> uv{{{0, 1}, {1, 1}, {1, 0}, {0, 0}}};
  const std::array<std::uint32_t, 6> indices{0, 1, 2, 0, 2, 3};
  AssetArrays arrays{.name = "square"};
  arrays.materials.push_back({.name = "skin"});
  arrays.meshes.push_back(
      {.name = "square", .material = 0, .positions_m = positions, .uv0 = uv, .indices = indices});

  auto opened = std::make_shared<viewer::Opened>();
  opened->words = {"square.glb"};
  opened->scene = Scene(Asset::from_arrays(arrays));
  return {.opened = opened, .scene = opened->scene};
}

}  // namespace dermis::tests
