// SPDX-License-Identifier: MIT
#include "render/passes/asset/first_corners.h"

#include <gtest/gtest.h>

#include "head/scene/import/shapes.h"

namespace dermis::passes {
namespace {

// As render/shaders/first_corner.glsl.
std::vector<std::uint32_t> drawn(const std::vector<std::uint32_t>& first_corners,
                                 const std::vector<std::uint32_t>& indices) {
  const std::size_t triangles = indices.size() / 3;
  std::vector<std::uint32_t> vertices;
  for (const std::uint32_t i : first_corners)
    vertices.push_back(i < triangles ? indices[3 * i] : static_cast<std::uint32_t>(i - triangles));
  return vertices;
}

void expect_first_corners(const std::vector<std::uint32_t>& indices) {
  const std::vector<std::uint32_t> found = first_corner_indices(indices);
  ASSERT_EQ(found.size(), indices.size());
  EXPECT_EQ(drawn(found, indices), indices);
  for (std::uint32_t t = 0; t < indices.size() / 3; ++t) ASSERT_EQ(found[3 * t], t);
}

TEST(FirstCorners, DrawTheSameTriangles) {
  expect_first_corners({});
  expect_first_corners({2, 1, 0});
  expect_first_corners({0, 1, 2, 0, 2, 3, 0, 3, 1});  // all have the same first corner
  expect_first_corners({5, 5, 5, 5, 6, 5, 6, 5, 7});  // without area, and vertices without a triangle

  const scene::AssetData large = scene::sphere(0.1, 110);
  ASSERT_GT(large.primitives.front().vertices.size(), 65535u);
  expect_first_corners(large.primitives.front().indices);
}

}  // namespace
}  // namespace dermis::passes
