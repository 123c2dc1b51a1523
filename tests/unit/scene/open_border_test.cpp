// SPDX-License-Identifier: MIT
// Distances from the open borders of a mesh.
#include "head/scene/surface/open_border.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "head/scene/import/shapes.h"
#include "unit/scene/skin_meshes.h"

namespace dermis::scene {
namespace {

constexpr float most_mm = 20;

/// Of a point of a square sheet of `side_mm` around the origin.
float straight_mm(const Vertex& v, float side_mm) {
  return side_mm / 2 - 1000 * std::max(std::abs(v.position_m.x), std::abs(v.position_m.y));
}

float largest(const std::vector<float>& values) { return *std::ranges::max_element(values); }

TEST(OpenBorder, OfASheet) {
  const SkinMesh mesh = only_mesh(plane(0.016, glm::dmat2(1), {}, 8));
  const std::vector<float> mm = border_distances_mm(mesh, 1000, most_mm);
  ASSERT_EQ(mm.size(), mesh.vertices.size());
  for (std::size_t v = 0; v < mm.size(); ++v) {
    const float wanted = straight_mm(mesh.vertices[v], 16);  // edges are parallel to the sides
    EXPECT_NEAR(mm[v], wanted, 1e-3) << v;
  }
  EXPECT_NEAR(largest(border_distances_mm(mesh, 1000, 3)), 3, 1e-3);
  EXPECT_NEAR(largest(border_distances_mm(mesh, 2000, most_mm)), 16, 1e-3);
}

// The unwrap of a sphere has seams, where vertices are split, but the skin does not end there.
TEST(OpenBorder, SeamsAreNone) {
  const SkinMesh mesh = only_mesh(sphere(0.05, 12));
  EXPECT_GT(mesh.charts, 1);
  for (const float mm : border_distances_mm(mesh, 1000, most_mm)) EXPECT_EQ(mm, most_mm);
}

TEST(OpenBorder, OfAHoleInASphere) {
  SkinMesh mesh = only_mesh(sphere(0.05, 12));
  mesh.indices.resize(mesh.indices.size() - 3);
  mesh.triangle_chart.resize(mesh.triangle_chart.size() - 1);
  mesh.triangle_material.resize(mesh.triangle_material.size() - 1);
  const std::vector<float> mm = border_distances_mm(mesh, 1000, most_mm);
  EXPECT_GE(std::ranges::count(mm, 0.0f), 3);
  EXPECT_LT(std::ranges::count(mm, 0.0f), 20) << "no more than the copies of three corners";
}

TEST(OpenBorder, OfNothing) { EXPECT_TRUE(border_distances_mm(SkinMesh{}, 1000, most_mm).empty()); }

}  // namespace
}  // namespace dermis::scene
