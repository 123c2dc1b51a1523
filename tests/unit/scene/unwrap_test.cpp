// SPDX-License-Identifier: MIT
#include "head/scene/surface/unwrap.h"

#include <gtest/gtest.h>

#include <cmath>
#include <set>

#include "head/scene/import/shapes.h"
#include "scan.h"
#include "skin_meshes.h"
#include "support/log_lines.h"

namespace dermis::scene {
namespace {

void expect_metric(const SkinMesh& mesh, const glm::dvec3& expected, double relative) {
  ASSERT_EQ(mesh.metric.size(), mesh.vertices.size());
  const double scale = std::max(expected.x, expected.z);
  for (const glm::vec3& g : mesh.metric) {
    EXPECT_NEAR(g.x, expected.x, relative * scale);
    EXPECT_NEAR(g.y, expected.y, relative * scale);
    EXPECT_NEAR(g.z, expected.z, relative * scale);
  }
}

TEST(Metric, PlaneInMillimetres) {
  expect_metric(only_mesh(plane(0.05, glm::dmat2(1), {}, 4)), {2500, 0, 2500}, 1e-5);
}

TEST(Metric, StretchedAndSheared) {
  expect_metric(only_mesh(plane(0.05, glm::dmat2(1.0 / 3, 0, 0, 1), {0.2, 0}, 4)), {9 * 2500, 0, 2500}, 1e-5);
  // (s, t) -> (s/2 + t/2, t/2): P = 50 mm (s, -t), s = 2u - 2v, t = 2v, so dP/du = (100, 0), dP/dv = (-100,
  // -100).
  expect_metric(only_mesh(plane(0.05, glm::dmat2(0.5, 0, 0.5, 0.5), {}, 4)), {1e4, -1e4, 2e4}, 1e-5);
}

TEST(Metric, CholeskyOfTheInverse) {
  for (const glm::dvec3& g : {glm::dvec3(2500, 0, 2500), glm::dvec3(1e4, -1e4, 2e4), glm::dvec3(3, 1.7, 1)}) {
    const glm::dvec3 l = inverse_metric_cholesky(g);
    EXPECT_GT(l.x, 0);
    EXPECT_GT(l.z, 0);
    const glm::dmat2 factor(l.x, l.y, 0, l.z);  // columns (a, b), (0, c)
    const glm::dmat2 product = glm::dmat2(g.x, g.y, g.y, g.z) * (factor * glm::transpose(factor));
    EXPECT_NEAR(product[0][0], 1, 1e-12);
    EXPECT_NEAR(product[0][1], 0, 1e-12);
    EXPECT_NEAR(product[1][0], 0, 1e-12);
    EXPECT_NEAR(product[1][1], 1, 1e-12);
  }
}

TEST(Metric, SphereIsSmoothWithinAndSymmetricBetweenCharts) {
  const SkinMesh mesh = only_mesh(sphere(0.01, 24));
  EXPECT_EQ(mesh.charts, 6);

  double area_mm2 = 0;  // integral of sqrt(det g) over the unwrap
  for (std::size_t i = 0; i < mesh.indices.size(); i += 3) {
    const auto uv = [&](std::size_t k) { return glm::dvec2(mesh.unwrap[mesh.indices[i + k]]); };
    double density = 0;
    for (std::size_t k = 0; k < 3; ++k) {
      const glm::dvec3 g(mesh.metric[mesh.indices[i + k]]);
      density += std::sqrt(g.x * g.z - g.y * g.y) / 3;
    }

    const glm::dvec2 a = uv(1) - uv(0), b = uv(2) - uv(0);
    area_mm2 += 0.5 * std::abs(a.x * b.y - a.y * b.x) * density;
  }

  const double exact = 4 * 3.14159265358979 * 100;
  EXPECT_NEAR(area_mm2 / exact, 1, 0.01);
  const UnwrapDensity density = unwrap_density(mesh, 1000);
  EXPECT_NEAR(density.area_mm2 / exact, 1, 0.005);
  EXPECT_LE(density.uv_per_mm.p50, density.uv_per_mm.p95);
  EXPECT_LE(density.uv_per_mm.p95, density.uv_per_mm.max);
  EXPECT_LE(density.uv_per_mm.mean, density.largest_uv_per_mm.mean);
}

TEST(Metric, DensityOfAPlane) {
  const UnwrapDensity density = unwrap_density(only_mesh(plane(0.05, glm::dmat2(0.25, 0, 0, 1))), 1000);
  EXPECT_NEAR(density.area_mm2, 2500, 1e-3);
  // 200 mm along u, 50 mm along v per unit
  EXPECT_NEAR(density.uv_per_mm.mean, 1 / std::sqrt(200.0 * 50), 1e-7);
  EXPECT_NEAR(density.largest_uv_per_mm.max, 1 / 50.0, 1e-7);
}

TEST(Metric, DegenerateTrianglesDoNotDisturb) {
  AssetData scene = plane(0.05, glm::dmat2(1), {}, 4);
  Primitive& p = scene.primitives[0];
  p.indices.insert(p.indices.end(), {3, 3, 4, 0, 1, 2});  // a point twice; three points on a line
  const auto n = static_cast<std::uint32_t>(p.vertices.size());
  Vertex sliver = p.vertices[0];  // 1e-5 of the map thin, 50 mm long: 5,000 m per unit of v
  p.vertices.push_back(sliver);
  sliver.uv0 += glm::vec2(0.5f, 1e-5f);
  sliver.position_m += glm::vec3(0, 0.05f, 0);
  p.vertices.push_back(sliver);
  p.indices.insert(p.indices.end(), {0, n + 1, 1, 0, n, 1});
  expect_metric(only_mesh(scene), {2500, 0, 2500}, 1e-4);
}

TEST(Metric, NothingValidStillPositiveDefinite) {
  AssetData scene = plane(0.05);
  for (Vertex& v : scene.primitives[0].vertices) v.uv0 = glm::vec2(0.5f);
  const SkinMesh mesh = only_mesh(scene);
  for (const glm::vec3& g : mesh.metric) EXPECT_GT(g.x * g.z - g.y * g.y, 0);
  EXPECT_EQ(unwrap_density(mesh, 1000).uv_per_mm.max, 0);
}

// Coordinates that span 1e-30 of the map, or a skin of 1e-25 m, squared: past what a float can be.
TEST(Metric, FloatsHoldItWhateverTheSizes) {
  tests::LogLines quiet;
  for (const AssetData& scene :
       {plane(0.05, glm::dmat2(1e-30)), plane(1e-25), plane(1e9, glm::dmat2(1e-9))}) {
    SkinMesh mesh = only_mesh(scene);
    for (const double mm_per_unit : {1e-6, 1e3, 1e9}) {
      compute_metric(mesh, mm_per_unit);
      for (const glm::vec3& g : mesh.metric) {
        EXPECT_TRUE(std::isfinite(g.x) && std::isfinite(g.y) && std::isfinite(g.z));
        EXPECT_GT(g.x * g.z - g.y * g.y, 0.0f);
      }
    }
  }
}

TEST(Metric, NeverAveragedAcrossAMirror) {
  // Two quads side by side that show the same half of the map, the left one mirrored and twice as wide in the
  // world.
  AssetData scene = plane(0.05);
  Primitive& p = scene.primitives[0];
  p.vertices.clear();
  for (const float y : {0.f, 1.f})
    for (const float x : {-2.f, 0.f, 1.f}) {
      Vertex v;
      v.position_m = 0.01f * glm::vec3(x, y, 0);
      v.uv0 = {x < 0 ? 1 : x, 1 - y};
      p.vertices.push_back(v);
    }
  p.indices = {0, 1, 4, 0, 4, 3, 1, 2, 5, 1, 5, 4};

  const SkinMesh mesh = only_mesh(scene);
  EXPECT_EQ(mesh.charts, 2);
  EXPECT_EQ(mesh.vertices.size(), 8u) << "each vertex belongs to one chart";
  EXPECT_EQ(mesh.layers, 2);

  // Each half takes a quarter of the map, less a margin.
  const double scale = mesh.unwrap_scale.x;
  EXPECT_NEAR(scale, 0.5 * (1 - 2.0 / 64), 1e-6);
  for (std::size_t i = 0; i < mesh.indices.size(); ++i)
    EXPECT_NEAR(mesh.metric[mesh.indices[i]].x * scale * scale, i < 6 ? 400 : 100, 0.01) << "corner " << i;
}

TEST(Unwrap, MovesByWholeTilesElseFits) {
  {
    tests::LogLines warnings;
    const SkinMesh mesh = only_mesh(plane(0.05, glm::dmat2(0.5), {3.25, -1.75}));
    EXPECT_EQ(mesh.unwrap_offset, glm::dvec2(-3, 2));
    EXPECT_EQ(mesh.unwrap_scale, glm::dvec2(1));
    EXPECT_TRUE(warnings.warnings.empty());
    expect_metric(mesh, {1e4, 0, 1e4}, 1e-5);
  }

  // Let u span two tiles: moving by whole tiles does not help, the unwrap is fitted.
  tests::LogLines warnings;
  const SkinMesh mesh = only_mesh(plane(0.05, glm::dmat2(2, 0, 0, 1), {-0.5, 0}));
  ASSERT_EQ(warnings.warnings.size(), 1u);
  EXPECT_FALSE(mesh.unwrap_note.empty());

  for (const glm::vec2& uv : mesh.unwrap) EXPECT_TRUE(uv.x >= 0 && uv.x <= 1 && uv.y >= 0 && uv.y <= 1);
  for (std::size_t v = 0; v < mesh.vertices.size(); ++v)
    EXPECT_LT(glm::distance(glm::dvec2(mesh.vertices[v].uv0) * mesh.unwrap_scale + mesh.unwrap_offset,
                            glm::dvec2(mesh.unwrap[v])),
              1e-6);
  expect_metric(mesh, {2500, 0, 2500}, 1e-5);
}

TEST(Unwrap, JoinsTheSkinOfANodeAndLeavesTheRest) {
  AssetData scene = plane(0.05);
  scene.materials.push_back(test::material("eyes", false));
  scene.materials.push_back(test::material("skin 2", true));
  Primitive more = scene.primitives[0];
  for (const int material : {1, 2}) more.material = material, scene.primitives.push_back(more);
  more.node = 7;
  scene.primitives.push_back(more);
  const std::vector<SkinMesh> meshes = skin_meshes(scene);
  ASSERT_EQ(meshes.size(), 2u);
  EXPECT_EQ(meshes[0].triangle_material, (std::vector<int>{0, 0, 2, 2}));
  EXPECT_EQ(meshes[1].key.node, 7);
  EXPECT_EQ(meshes[1].triangle_material, (std::vector<int>{2, 2}));
}

TEST(Unwrap, ManyChartsWrapTheirIds) {
  AssetData scene = plane(0.05);
  Primitive& p = scene.primitives[0];
  const Primitive quad = p;
  p.vertices.clear(), p.indices.clear();
  for (std::uint32_t i = 0; i < 2050; ++i) {
    for (Vertex v : quad.vertices) {
      v.position_m.z += static_cast<float>(i);
      p.vertices.push_back(v);
    }
    for (const std::uint32_t index : quad.indices) p.indices.push_back(4 * i + index);
  }
  const SkinMesh mesh = only_mesh(scene);
  EXPECT_EQ(mesh.charts, 2050);
  EXPECT_EQ(mesh.triangle_chart.front(), 1);
  EXPECT_EQ(mesh.triangle_chart[2 * 2045], 2046);
  EXPECT_EQ(mesh.triangle_chart[2 * 2046], 1);
}

TEST(Unwrap, Scan) {
  DERMIS_NEED_SCAN(scan);
  const SkinMesh mesh = only_mesh(*scan);
  EXPECT_TRUE(mesh.unwrap_note.empty());
  EXPECT_GT(mesh.charts, 1);

  std::vector<double> cosines;
  for (const glm::vec3& g : mesh.metric) {
    ASSERT_TRUE(std::isfinite(g.x) && std::isfinite(g.y) && std::isfinite(g.z));
    ASSERT_GT(g.x * g.z - g.y * g.y, 0);
    const glm::dvec3 l = inverse_metric_cholesky(glm::dvec3(g));
    ASSERT_TRUE(std::isfinite(l.x) && std::isfinite(l.y) && std::isfinite(l.z));
    cosines.push_back(std::abs(g.y) / std::sqrt(g.x * g.z));
  }

  std::nth_element(cosines.begin(), cosines.begin() + static_cast<std::ptrdiff_t>(cosines.size() / 2),
                   cosines.end());
  EXPECT_NEAR(cosines[cosines.size() / 2], 0.35, 0.05) << "u and v are far from orthogonal on the scan";

  const UnwrapDensity density = unwrap_density(mesh, 1000);
  RecordProperty("charts", mesh.charts);
  EXPECT_GT(density.area_mm2, 1e5);
  EXPECT_LT(density.area_mm2, 1e6);
  EXPECT_GT(density.uv_per_mm.p50 * 2048, 1);
  EXPECT_LT(density.uv_per_mm.p50 * 2048, 10);
}

TEST(SkinMesh, SkinWithoutCoordinatesIsOneMeshAMaterial) {
  AssetData scene = sphere(0.1, 2);
  const Primitive ball = scene.primitives[0];
  for (int node = 1; node <= 500; ++node) {
    scene.primitives.push_back(ball);
    scene.primitives.back().node = node;
    scene.primitives.back().has_uv = false;
  }
  const std::vector<SkinMesh> meshes = skin_meshes(scene);
  ASSERT_EQ(meshes.size(), 2u);
  EXPECT_EQ(meshes[1].indices.size(), 500 * ball.indices.size());
}

}  // namespace
}  // namespace dermis::scene
