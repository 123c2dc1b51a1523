// SPDX-License-Identifier: MIT
// Texture coordinates that leave most of the map empty, or that no map can hold.
#include "head/scene/surface/unwrap_fit.h"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "head/scene/import/shapes.h"
#include "head/scene/surface/coverage.h"
#include "skin_meshes.h"
#include "support/log_lines.h"

namespace dermis::scene {
namespace {

/// The sphere of six charts with uv = factor * uv + offset.
AssetData moved_sphere(const glm::dmat2& factor, const glm::dvec2& offset = {}) {
  AssetData scene = sphere(0.1, 12);
  for (Vertex& v : scene.primitives[0].vertices) v.uv0 = glm::vec2(factor * glm::dvec2(v.uv0) + offset);
  return scene;
}

AssetData scaled_sphere(double factor, const glm::dvec2& offset = {}) {
  return moved_sphere(glm::dmat2(factor), offset);
}

double mean_density(const AssetData& scene) { return unwrap_density(only_mesh(scene), 1000).uv_per_mm.mean; }

std::size_t chartless(const SkinMesh& mesh) {
  return static_cast<std::size_t>(
      std::count(mesh.triangle_chart.begin(), mesh.triangle_chart.end(), no_chart));
}

void expect_inside(const SkinMesh& mesh, double margin) {
  for (const std::uint32_t index : mesh.indices) {
    if (mesh.unwrap[index] == glm::vec2(0)) continue;  // of triangles without a chart
    for (const float x : {mesh.unwrap[index].x, mesh.unwrap[index].y}) {
      ASSERT_GE(double{x}, margin - 1e-6);
      ASSERT_LE(double{x}, 1 - margin + 1e-6);
    }
  }
}

TEST(UnwrapFit, ASmallUnwrapGetsTheWholeMap) {
  const double plain = mean_density(scaled_sphere(1));
  for (const double scale : {0.4, 0.1, 0.01, 0.001})
    for (const double offset : {0.0, 0.3}) {
      SCOPED_TRACE(fmt::format("scale {}, offset {}", scale, offset));
      tests::LogLines warnings;
      const AssetData scene = scaled_sphere(scale, glm::dvec2(offset));
      const SkinMesh mesh = only_mesh(scene);
      EXPECT_EQ(mesh.charts, 6);
      EXPECT_EQ(chartless(mesh), 0u);
      expect_inside(mesh, fit_margin);
      EXPECT_GE(mean_density(scene), plain);
      EXPECT_EQ(mesh.vertices[5].uv0, scene.primitives[0].vertices[5].uv0) << "maps are read where they were";
      EXPECT_TRUE(warnings.warnings.empty());
    }
}

TEST(UnwrapFit, FlippedAndTurnedOnes) {
  const double plain = mean_density(scaled_sphere(1));
  for (const glm::dmat2& factor : {glm::dmat2(-0.05, 0, 0, 0.05), glm::dmat2(0, 0.02, -0.02, 0)})
    EXPECT_GE(mean_density(moved_sphere(factor, {0.5, 0.5})), 0.99 * plain);
}

TEST(UnwrapFit, WhatFillsAQuarterStaysAsItIs) {
  for (const double scale : {1.0, 0.6}) {
    const AssetData scene = scaled_sphere(scale);
    const SkinMesh mesh = only_mesh(scene);
    for (std::size_t v = 0; v < mesh.vertices.size(); ++v) ASSERT_EQ(mesh.unwrap[v], mesh.vertices[v].uv0);
  }
}

// Squeezed coordinates are stretched again; a band of skin that is even already is not torn apart for it.
TEST(UnwrapFit, AxesGrowUntilOneIsTwiceAsFine) {
  const AssetData squeezed = moved_sphere(glm::dmat2(0.02, 0, 0, 1));
  EXPECT_GE(mean_density(squeezed), 0.9 * mean_density(scaled_sphere(1)));

  AssetData band = plane(0.1);
  for (Vertex& v : band.primitives[0].vertices) v.position_m.y *= 0.05f, v.uv0.y *= 0.05f;
  const SkinMesh mesh = only_mesh(band);
  EXPECT_NEAR(mesh.unwrap_scale.x, 1, 1e-12);
  EXPECT_NEAR(mesh.unwrap_scale.y, 2 * (1 - 2 * fit_margin), 1e-6);
}

TEST(UnwrapFit, AStrayTriangleDoesNotShrinkTheRest) {
  for (const float far : {10.0f, 30.0f, 100.0f}) {
    SCOPED_TRACE(far);
    AssetData scene = scaled_sphere(0.1);
    Primitive& p = scene.primitives[0];

    // Move two corners of the first triangle far away on the map.
    const auto n = static_cast<std::uint32_t>(p.vertices.size());
    for (std::uint32_t k = 0; k < 3; ++k) {
      Vertex v = p.vertices[p.indices[k]];
      v.uv0 = k == 0 ? v.uv0 : v.uv0 + glm::vec2(far, -far);
      p.vertices.push_back(v);
      p.indices[k] = n + k;
    }

    tests::LogLines warnings;
    const SkinMesh mesh = only_mesh(scene);
    EXPECT_EQ(chartless(mesh), 1u);
    EXPECT_EQ(mesh.triangle_chart[0], no_chart);
    expect_inside(mesh, fit_margin);
    EXPECT_GE(unwrap_density(mesh, 1000).uv_per_mm.mean, 0.99 * mean_density(scaled_sphere(1)));

    ASSERT_EQ(warnings.warnings.size(), 1u);
    EXPECT_NE(warnings.warnings[0].find("1 of its 1728 triangles"), std::string::npos)
        << warnings.warnings[0];
  }
}

TEST(UnwrapFit, ACubeWithOneTriangleFarAway) {
  AssetData scene = sphere(0.1, 1);  // twelve triangles: each is 8 % of the skin
  Primitive& p = scene.primitives[0];
  for (std::uint32_t k = 0; k < 3; ++k) {
    Vertex v = p.vertices[p.indices[k]];
    v.uv0 += glm::vec2(5000);
    p.vertices.push_back(v);
    p.indices[k] = static_cast<std::uint32_t>(p.vertices.size()) - 1;
  }
  const SkinMesh mesh = only_mesh(scene);
  EXPECT_EQ(chartless(mesh), 1u);
  EXPECT_GT(uv_area_sum(mesh), 0.4);
}

TEST(UnwrapFit, TwoHalvesFarApartShareTheMap) {
  AssetData scene = scaled_sphere(0.5);
  for (Vertex& v : scene.primitives[0].vertices)
    if (v.uv0.x > 0.25f) v.uv0.x += 100;
  tests::LogLines warnings;
  const SkinMesh mesh = only_mesh(scene);
  EXPECT_EQ(chartless(mesh), 0u);
  expect_inside(mesh, 0);
  EXPECT_EQ(warnings.warnings.size(), 1u);
}

TEST(UnwrapFit, TrianglesWithoutAreaHaveNoChart) {
  AssetData scene = scaled_sphere(1);
  Primitive& p = scene.primitives[0];
  for (std::size_t t = 0; t < p.indices.size() / 3; t += 2)
    for (std::size_t k = 0; k < 3; ++k) {
      Vertex v = p.vertices[p.indices[3 * t + k]];
      v.uv0 = t % 4 == 0 ? glm::vec2(0.25f) : glm::vec2(std::numeric_limits<float>::quiet_NaN());
      p.vertices.push_back(v);
      p.indices[3 * t + k] = static_cast<std::uint32_t>(p.vertices.size()) - 1;
    }
  const SkinMesh mesh = only_mesh(scene);
  for (std::size_t t = 0; t < mesh.triangle_chart.size(); ++t)
    ASSERT_EQ(mesh.triangle_chart[t] == no_chart, t % 2 == 0);
  for (const glm::vec3& g : mesh.metric) ASSERT_TRUE(std::isfinite(g.x) && g.x * g.z > g.y * g.y);
}

TEST(UnwrapFit, CollapsedToALineOrAPoint) {
  for (const glm::dmat2& factor : {glm::dmat2(0), glm::dmat2(1, 0, 0, 0), glm::dmat2(1, 1, 1, 1)}) {
    const SkinMesh mesh = only_mesh(moved_sphere(factor, {0.1, 0.1}));
    EXPECT_EQ(chartless(mesh), mesh.triangle_chart.size());
    EXPECT_EQ(mesh.charts, 0);
    EXPECT_EQ(unwrap_density(mesh, 1000).uv_per_mm.max, 0);
  }
}

}  // namespace
}  // namespace dermis::scene
