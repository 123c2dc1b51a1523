// SPDX-License-Identifier: MIT
#include "head/scene/surface/overlapping_skin.h"

#include <gtest/gtest.h>

#include <vector>

#include "base/core/error.h"
#include "head/scene/import/limits.h"
#include "head/scene/import/shapes.h"
#include "head/scene/surface/unwrap.h"

namespace dermis::scene {
namespace {

/// Where the texture coordinates of a material lie: a square of this side from a corner.
struct Square {
  glm::vec2 corner;
  float side = 1;
};

/// One node, a material of skin for each square.
AssetData node_of(const std::vector<Square>& squares) {
  AssetData scene;
  for (const Square& square : squares) {
    AssetData sheet = plane(0.05, glm::dmat2(1), {}, 4);
    Primitive primitive = sheet.primitives[0];
    for (Vertex& v : primitive.vertices) v.uv0 = square.corner + square.side * v.uv0;
    primitive.node = 3;
    primitive.material = static_cast<int>(scene.materials.size());
    scene.primitives.push_back(primitive);
    scene.materials.push_back(sheet.materials[0]);
  }
  part_overlapping_skin("file", scene);
  return scene;
}

std::vector<int> triangles_of(const AssetData& scene) {
  std::vector<int> count;
  for (const SkinMesh& mesh : skin_meshes(scene)) count.push_back(static_cast<int>(mesh.indices.size() / 3));
  return count;
}

TEST(OverlappingSkin, HasALightMapForEachMaterial) {
  EXPECT_EQ(triangles_of(node_of({{{0, 0}}, {{0, 0}}})), (std::vector{32, 32}));
  EXPECT_EQ(triangles_of(node_of({{{2, 5}}, {{2, 5}}})), (std::vector{32, 32})) << "in another tile";
}

TEST(OverlappingSkin, ASmallPatchInTheChartOfAnotherHasItsOwn) {
  EXPECT_EQ(triangles_of(node_of({{{0, 0}}, {{0.45f, 0.6f}, 0.06f}})), (std::vector{32, 32}));
}

TEST(OverlappingSkin, WhatLiesBesideItShares) {
  EXPECT_EQ(triangles_of(node_of({{{0, 0}, 0.5f}, {{0.5f, 0}, 0.5f}})), (std::vector{64})) << "with a border";
  EXPECT_EQ(triangles_of(node_of({{{0, 0}}, {{1, 0}}, {{0, 1}}})), (std::vector{96})) << "tiles";
  EXPECT_EQ(triangles_of(node_of({{{0, 0}, 0.4f}, {{0, 0}, 0.4f}, {{0.5f, 0}, 0.4f}, {{0.5f, 0.5f}, 0.4f}})),
            (std::vector{32, 32, 64}));
}

TEST(OverlappingSkin, IsLimitedInNumber) {
  const std::vector<Square> same(most_skin_nodes + 1, Square{{0, 0}});
  EXPECT_THROW(node_of(same), InputError);
}

}  // namespace
}  // namespace dermis::scene
