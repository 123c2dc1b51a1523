// SPDX-License-Identifier: MIT
#include "passes/first_corners.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <deque>

#include "scene/primitives.h"

namespace dermis::passes {
namespace {

// As shaders/first_corner.glsl.
std::vector<std::uint32_t> drawn(const std::vector<std::uint32_t>& first_corners,
                                 const std::vector<std::uint32_t>& indices) {
  const std::size_t triangles = indices.size() / 3;
  std::vector<std::uint32_t> vertices;
  for (const std::uint32_t i : first_corners)
    vertices.push_back(i < triangles ? indices[3 * i] : static_cast<std::uint32_t>(i - triangles));
  return vertices;
}

// Vertices that a device shades which remembers the last 16.
std::size_t shaded(const std::vector<std::uint32_t>& indices) {
  std::deque<std::uint32_t> cache;
  std::size_t count = 0;
  for (const std::uint32_t index : indices) {
    if (std::find(cache.begin(), cache.end(), index) != cache.end()) continue;
    ++count;
    cache.push_back(index);
    if (cache.size() > 16) cache.pop_front();
  }
  return count;
}

void expect_first_corners(const std::vector<std::uint32_t>& indices, std::size_t vertices) {
  const std::vector<std::uint32_t> found = first_corner_indices(indices, vertices);
  ASSERT_EQ(found.size(), indices.size());
  EXPECT_EQ(drawn(found, indices), indices);
  for (std::uint32_t t = 0; t < indices.size() / 3; ++t) ASSERT_EQ(found[3 * t], t);
}

TEST(FirstCorners, DrawTheSameTriangles) {
  expect_first_corners({}, 0);
  expect_first_corners({2, 1, 0}, 3);
  expect_first_corners({0, 1, 2, 0, 2, 3, 0, 3, 1}, 4);  // all have the same first corner
  expect_first_corners({5, 5, 5, 5, 6, 5, 6, 5, 7}, 9);  // without area; and vertices without a triangle
}

TEST(FirstCorners, AreFoundAgain) {
  const scene::Scene made = scene::sphere(0.1, 110);
  const scene::Primitive& p = made.primitives.front();
  ASSERT_GT(p.vertices.size(), 65535u);
  expect_first_corners(p.indices, p.vertices.size());

  // Each triangle has one that no other has, and half a vertex besides; without the latter's reuse 3.
  const std::size_t triangles = p.indices.size() / 3;
  EXPECT_LT(shaded(first_corner_indices(p.indices, p.vertices.size())), triangles * 22 / 10);
}

}  // namespace
}  // namespace dermis::passes
