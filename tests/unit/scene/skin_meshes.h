// SPDX-License-Identifier: MIT
// What the tests of unwraps share.
#pragma once

#include <gtest/gtest.h>

#include <string>
#include <utility>
#include <vector>

#include "head/scene/asset_data.h"
#include "head/scene/surface/unwrap.h"

namespace dermis::scene {

inline SkinMesh only_mesh(const AssetData& scene) {
  std::vector<SkinMesh> meshes = skin_meshes(scene);
  EXPECT_EQ(meshes.size(), 1u);
  return std::move(meshes.at(0));
}

}  // namespace dermis::scene
