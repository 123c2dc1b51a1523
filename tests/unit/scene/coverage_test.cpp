// SPDX-License-Identifier: MIT
#include "head/scene/surface/coverage.h"
#include "head/scene/surface/measured.h"

#include <gtest/gtest.h>

#include <random>

#include "head/scene/import/shapes.h"
#include "scan.h"
#include "skin_meshes.h"
#include "support/log_lines.h"

namespace dermis::scene {
namespace {

/// Two copies of a square of the map, side by side in the world; the second moved by `shift` on the map.
AssetData two_squares(glm::vec2 shift) {
  AssetData scene = plane(0.05, glm::dmat2(0.5), {}, 2);
  Primitive& p = scene.primitives[0];
  const auto n = static_cast<std::uint32_t>(p.vertices.size());
  const std::vector<std::uint32_t> indices = p.indices;
  for (std::uint32_t v = 0; v < n; ++v) {
    Vertex copy = p.vertices[v];
    copy.position_m.x += 0.1f;
    copy.uv0 += shift;
    p.vertices.push_back(copy);
  }
  for (const std::uint32_t i : indices) p.indices.push_back(n + i);
  return scene;
}

// The centres of the first row lie above the level edge of this sliver; followed up to there, its other edges
// begin past the map. It wrote behind the row, and in the last row behind the map.
TEST(Coverage, NothingOutsideTheMapIsCoveredAboveALevelEdge) {
  constexpr int side = 32;
  for (const float row : {10.0f, 31.0f}) {
    const std::array<glm::vec2, 3> sliver = {glm::vec2(5, row + 0.7f) / float{side},
                                             glm::vec2(28, row + 0.7f) / float{side},
                                             glm::vec2(0, row + 0.72f) / float{side}};
    for_each_texel(sliver, side, [](int x, int y) { ADD_FAILURE() << x << ", " << y; });
  }
}

TEST(Coverage, EveryTexelOnceWhereTrianglesShareEdges) {
  // Jittered grids, edges and vertices on texel centres among them: neither gaps nor double texels.
  std::mt19937 random(3);
  for (const double jitter : {0.0, 0.3}) {
    constexpr int cells = 8, side = 64;
    std::uniform_real_distribution<double> noise(-jitter, jitter);

    std::vector<glm::vec2> points;
    for (int y = 0; y <= cells; ++y)
      for (int x = 0; x <= cells; ++x) {
        const bool rim = x == 0 || y == 0 || x == cells || y == cells;
        const double shift = 0.5 / side;  // vertices on texel centres
        points.emplace_back(glm::dvec2(x + (rim ? 0 : noise(random)), y + (rim ? 0 : noise(random))) /
                                double(cells) +
                            (rim ? 0 : shift));
      }

    std::vector<int> count(side * side, 0);
    const auto add = [&](int a, int b, int c) {
      const auto at = [&](int i) { return points[static_cast<std::size_t>(i)]; };
      for_each_texel({at(a), at(b), at(c)}, side,
                     [&](int x, int y) { ++count[static_cast<std::size_t>(y * side + x)]; });
    };

    for (int y = 0; y < cells; ++y)
      for (int x = 0; x < cells; ++x) {
        const int i = y * (cells + 1) + x;
        add(i, i + 1, i + cells + 2);
        add(i, i + cells + 1, i + cells + 2);  // the other winding
      }

    for (const int c : count) ASSERT_EQ(c, 1);
  }
}

TEST(Coverage, TopLeftRule) {
  // A square whose border runs through texel centres 1.5 and 3.5: top and left centres count, bottom and
  // right ones do not.
  std::vector<glm::ivec2> texels;
  const auto p = [](double x, double y) { return glm::vec2(glm::dvec2(x, y) / 8.0); };
  const auto visit = [&](int x, int y) { texels.emplace_back(x, y); };
  for_each_texel({p(1.5, 1.5), p(3.5, 1.5), p(1.5, 3.5)}, 8, visit);
  for_each_texel({p(3.5, 1.5), p(3.5, 3.5), p(1.5, 3.5)}, 8, visit);
  std::sort(texels.begin(), texels.end(),
            [](auto a, auto b) { return std::pair(a.y, a.x) < std::pair(b.y, b.x); });
  EXPECT_EQ(texels, (std::vector<glm::ivec2>{{1, 1}, {2, 1}, {1, 2}, {2, 2}}));
}

TEST(Coverage, StaysOnTheMap) {
  for_each_texel({glm::vec2(-0.7f, -0.7f), glm::vec2(1.9f, 0.1f), glm::vec2(0.5f, 1.9f)}, 16,
                 [&](int x, int y) { ASSERT_TRUE(x >= 0 && x < 16 && y >= 0 && y < 16); });
  // Thin, steep and long: the row's span is found without leaving integers.
  for_each_texel({glm::vec2(0, 0), glm::vec2(1, 1e-6f), glm::vec2(1, 2e-3f)}, 16384,
                 [&](int x, int y) { ASSERT_LT(std::max(x, y), 16384); });
}

// Steps of an eighth of a turn, whose outer ends rise, on the map seen from above: one chart, which
// overlaps itself where it goes on for more than one turn.
AssetData spiral_stairs(int steps) {
  AssetData scene = plane(0.05);
  Primitive& p = scene.primitives[0];
  p.vertices.clear();
  p.indices.clear();
  for (int i = 0; i <= steps; ++i)
    for (const float r : {0.0f, 0.4f}) {
      Vertex v;
      const double angle = i * std::acos(-1.0) / 4;
      v.position_m = glm::vec3(r * std::cos(angle), r * std::sin(angle), r > 0 ? 0.001 * i : 0);
      v.uv0 = glm::vec2(0.5f) + glm::vec2(v.position_m);
      p.vertices.push_back(v);
    }
  for (std::uint32_t i = 0; i < static_cast<std::uint32_t>(steps); ++i)
    for (const std::uint32_t corner : {2 * i, 2 * i + 1, 2 * i + 3}) p.indices.push_back(corner);
  return scene;
}

TEST(Overlap, Fractions) {
  EXPECT_EQ(uv_overlap_fraction(only_mesh(plane(0.05, glm::dmat2(1), {}, 7))), 0);
  EXPECT_EQ(uv_overlap_fraction(only_mesh(sphere(0.1, 12))), 0);
  EXPECT_EQ(uv_overlap_fraction(only_mesh(spiral_stairs(8))), 0);
  EXPECT_NEAR(uv_overlap_fraction(only_mesh(spiral_stairs(12))), 0.5, 0.01);
  EXPECT_EQ(uv_overlap_fraction(only_mesh(spiral_stairs(16))), 1);
}

TEST(Overlap, ChartsLieApart) {
  const std::pair<glm::vec2, int> layers[] = {
      {{0, 0}, 2}, {{0.5f, 0}, 1}, {{0.25f, 0}, 2}, {{0.4985f, 0}, 1}};
  for (const auto& [shift, wanted] : layers) {
    const SkinMesh mesh = only_mesh(two_squares(shift));
    EXPECT_EQ(mesh.layers, wanted) << shift.x;
    EXPECT_LT(uv_overlap_fraction(mesh), 0.005) << shift.x;
    for (const glm::vec2& at : mesh.unwrap)
      EXPECT_TRUE(at.x >= 0 && at.x <= 1 && at.y >= 0 && at.y <= 1) << at.x << ", " << at.y;
  }
  EXPECT_EQ(only_mesh(spiral_stairs(16)).layers, 1) << "it is one chart";

  AssetData twice = plane(0.05, glm::dmat2(1), {}, 2);
  const std::vector<std::uint32_t> once = twice.primitives[0].indices;
  twice.primitives[0].indices.insert(twice.primitives[0].indices.end(), once.begin(), once.end());
  EXPECT_EQ(only_mesh(twice).layers, 1) << "the same triangles, twice";
  for (std::size_t i = once.size(); i < 2 * once.size(); i += 3)
    std::swap(twice.primitives[0].indices[i], twice.primitives[0].indices[i + 1]);
  EXPECT_EQ(only_mesh(twice).layers, 2) << "the inside of a double wall";

  // Two squares on the same coordinates, the second of them twice: both copies are on its layer.
  AssetData pair = two_squares({0, 0});
  std::vector<std::uint32_t>& indices = pair.primitives[0].indices;
  const std::vector<std::uint32_t> second(indices.begin() + static_cast<std::ptrdiff_t>(indices.size() / 2),
                                          indices.end());
  indices.insert(indices.end(), second.begin(), second.end());
  const SkinMesh mesh = only_mesh(pair);
  EXPECT_EQ(mesh.layers, 2);
  const std::size_t first_copy = mesh.indices.size() / 3, second_copy = 2 * first_copy;
  for (std::size_t i = 0; i < second.size(); ++i)
    EXPECT_EQ(mesh.unwrap[mesh.indices[first_copy + i]], mesh.unwrap[mesh.indices[second_copy + i]]) << i;
}

TEST(Overlap, WarnsFromHalfAPercentOn) {
  tests::LogLines said;
  const auto few = measured(two_squares({0.4985f, 0})), many = measured(spiral_stairs(12));
  EXPECT_NEAR(few->skin.front().overlap, 0.0015, 0.002);
  EXPECT_TRUE(said.all.empty());
  warn_overlap(few->skin.front());
  EXPECT_TRUE(said.all.empty());
  warn_overlap(many->skin.front());
  ASSERT_EQ(said.all.size(), 1u);
  EXPECT_NE(said.all[0].find("50.0 %"), std::string::npos) << said.all[0];
}

TEST(Overlap, Scan) {
  DERMIS_NEED_SCAN(scan);
  const double fraction = uv_overlap_fraction(only_mesh(*scan));
  EXPECT_LT(fraction, 0.005);
  RecordProperty("overlap_percent", std::to_string(100 * fraction));
}

}  // namespace
}  // namespace dermis::scene
