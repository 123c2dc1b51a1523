// SPDX-License-Identifier: MIT
#include "head/scene/surface/gutters.h"

#include <gtest/gtest.h>

#include <chrono>
#include <cmath>
#include <functional>
#include <map>
#include <numbers>

#include "head/scene/import/shapes.h"
#include "head/scene/surface/coverage.h"
#include "head/scene/surface/tangents.h"
#include "scan.h"
#include "skin_meshes.h"
#include "support/log_lines.h"
#include "support/sanitized.h"

namespace dermis::scene {
namespace {

using std::numbers::pi;

/// Chart per texel by coverage, 0 = none.
std::vector<int> coverage(const SkinMesh& mesh, int side) {
  std::vector<int> chart(static_cast<std::size_t>(side * side), 0);
  for (std::size_t t = 0; t < mesh.triangle_chart.size(); ++t)
    for_each_texel(triangle_uv(mesh, t), side, [&](int x, int y) {
      chart[static_cast<std::size_t>(y * side + x)] = mesh.triangle_chart[t];
    });
  return chart;
}

/// The promises that hold for every list.
void expect_sound(const SkinMesh& mesh, const std::vector<GutterTexel>& gutters, int side) {
  std::vector<int> chart = coverage(mesh, side);
  for (const GutterTexel& g : gutters) chart[static_cast<std::size_t>(g.y * side + g.x)] = 0;

  int last = -1;
  for (const GutterTexel& g : gutters) {
    ASSERT_LT(last, g.y * side + g.x) << "sorted, each texel once";
    last = g.y * side + g.x;

    const int x = static_cast<int>(std::floor(g.source_x - 0.5)),
              y = static_cast<int>(std::floor(g.source_y - 0.5));
    const double fx = g.source_x - 0.5 - x, fy = g.source_y - 0.5 - y;

    // Check the texels that a bilinear read at the source takes in: covered, all of one chart.
    int found = 0;
    for (const int dy : {0, 1})
      for (const int dx : {0, 1}) {
        if ((dx == 1 ? fx : 1 - fx) * (dy == 1 ? fy : 1 - fy) == 0) continue;
        ASSERT_TRUE(x + dx >= 0 && y + dy >= 0 && x + dx < side && y + dy < side);
        const int c = chart[static_cast<std::size_t>((y + dy) * side + x + dx)];
        ASSERT_NE(c, 0) << "the source of " << g.x << ' ' << g.y << " reads a texel that is not covered";
        ASSERT_TRUE(found == 0 || found == c) << "the source of " << g.x << ' ' << g.y << " reads two charts";
        found = c;
      }
  }
}

using Surface = std::function<glm::dvec3(glm::dvec2)>;  ///< of parameters in mm

/// A grid over [low, high] of a surface; uv = transform * parameters + offset. Both scenes' positions in
/// metres.
void append_patch(Primitive& primitive, const Surface& surface, glm::dvec2 low, glm::dvec2 high,
                  const glm::dmat2& transform, glm::dvec2 offset, int n) {
  const auto base = static_cast<std::uint32_t>(primitive.vertices.size());
  for (int j = 0; j <= n; ++j)
    for (int i = 0; i <= n; ++i) {
      const glm::dvec2 s = glm::mix(low, high, glm::dvec2(i, j) / double(n));
      Vertex v;
      v.position_m = glm::vec3(surface(s) * 1e-3);
      v.uv0 = glm::vec2(transform * s + offset);
      primitive.vertices.push_back(v);
    }
  for (int j = 0; j < n; ++j)
    for (int i = 0; i < n; ++i) {
      const std::uint32_t a = base + static_cast<std::uint32_t>(j * (n + 1) + i),
                          b = a + static_cast<std::uint32_t>(n + 1);
      primitive.indices.insert(primitive.indices.end(), {a, a + 1, b + 1, a, b + 1, b});
    }
}

SkinMesh mesh_from(Primitive primitive) {
  AssetData scene = plane(0.05);
  primitive.node = 0;
  make_missing_normals(primitive);
  scene.primitives[0] = std::move(primitive);
  return only_mesh(scene);
}

TEST(Gutters, CylinderSeamGoesRoundToItsOtherSide) {
  // 100 mm around, 40 mm high, unrolled with its seam at u = 0.1 and 0.9: 1 mm = 0.008 of the map.
  const auto cylinder = [](glm::dvec2 s) {
    const double a = std::fmod(s.x, 100.0) / 100 * 2 * pi;
    return glm::dvec3(std::cos(a), std::sin(a), 0) * (100 / (2 * pi)) + glm::dvec3(0, 0, s.y);
  };

  Primitive p;
  append_patch(p, cylinder, {0, 0}, {100, 40}, glm::dmat2(0.008, 0, 0, 0.008), {0.1, 0.1}, 40);
  const SkinMesh mesh = mesh_from(p);
  EXPECT_EQ(mesh.charts, 1);

  constexpr int side = 250, width = 12;  // 200 texels around
  const std::vector<GutterTexel> gutters = build_gutters(mesh, side, width);
  expect_sound(mesh, gutters, side);

  int seam = 0, open = 0;
  for (const GutterTexel& g : gutters) {
    if (g.chart == 0) {
      ++open;
      continue;
    }
    ++seam;
    EXPECT_EQ(g.chart, 1);
    // Facets are chords, straight across the seam: exactly 200 texels further round, but kept half a texel
    // away from the rim.
    const double expected = g.x < 100 ? g.x + 0.5 + 200 : g.x + 0.5 - 200;
    EXPECT_NEAR(g.source_x, std::clamp(expected, 25.5, 224.5), 2e-3) << g.x << ' ' << g.y;
    EXPECT_NEAR(g.source_y, g.y + 0.5, 2e-3);
  }

  EXPECT_EQ(seam, 2 * 12 * 80) << "12 texels left and right of 80 rows";
  EXPECT_GE(open, 2 * 2 * 200);
}

TEST(Gutters, FoldedPlanesContinueEachOther) {
  // Two planes, 90 degrees apart, on the map turned by 90 degrees, mirrored, and at 0.7 times the scale.
  const auto floor = [](glm::dvec2 s) { return glm::dvec3(s.x, s.y, 0); };
  const auto wall = [](glm::dvec2 s) { return glm::dvec3(40, s.y, s.x); };

  for (const bool mirrored : {false, true}) {
    Primitive p;
    append_patch(p, floor, {0, 0}, {40, 40}, glm::dmat2(0.01, 0, 0, 0.01), {0.05, 0.05}, 7);
    const glm::dmat2 turned(0, mirrored ? 0.007 : -0.007, 0.007, 0);
    append_patch(p, wall, {0, 0}, {40, 40}, turned, {0.6, mirrored ? 0.6 : 0.9}, 7);
    const SkinMesh mesh = mesh_from(p);
    EXPECT_EQ(mesh.charts, 2);

    constexpr int side = 512, width = 16;
    const std::vector<GutterTexel> gutters = build_gutters(mesh, side, width);
    expect_sound(mesh, gutters, side);

    int from_floor = 0, from_wall = 0;
    double worst = 0;
    for (const GutterTexel& g : gutters) {
      const glm::dvec2 uv = glm::dvec2(g.x + 0.5, g.y + 0.5) / double(side),
                       source = glm::dvec2(g.source_x, g.source_y) / double(side);

      if (g.chart == 1) {  // floor: beyond x = 40 lies the wall at height x - 40
        const glm::dvec2 mm = (uv - 0.05) / 0.01;
        if (mm.y < 0 || mm.y > 40) continue;
        const bool clear = mm.y > 1 && mm.y < 39;  // of the open ends, where sources give way too
        const glm::dvec2 expected =
            turned * glm::dvec2(mm.x - 40, mm.y) + glm::dvec2(0.6, mirrored ? 0.6 : 0.9);
        worst = std::max(worst, glm::distance(source, expected) * side);
        if (clear && (mm.x - 40) * 0.007 * side > 1) {
          EXPECT_LT(glm::distance(source, expected) * side, 0.02) << g.x << ' ' << g.y;
        }
        ++from_floor;
      } else if (g.chart == 2) {  // wall: below z = 0 lies the floor
        const glm::dvec2 mm = glm::inverse(turned) * (uv - glm::dvec2(0.6, mirrored ? 0.6 : 0.9));
        if (mm.y < 0 || mm.y > 40) continue;
        const bool clear = mm.y > 1 && mm.y < 39;  // of the open ends, where sources give way too
        const glm::dvec2 expected = glm::dvec2(40 + mm.x, mm.y) * 0.01 + 0.05;
        worst = std::max(worst, glm::distance(source, expected) * side);
        if (clear && -mm.x * 0.01 * side > 1) {
          EXPECT_LT(glm::distance(source, expected) * side, 0.02) << g.x << ' ' << g.y;
        }
        ++from_wall;
      }
    }

    EXPECT_GT(from_floor, 16 * 200);
    EXPECT_GT(from_wall, 16 * 140);
    EXPECT_LT(worst, 1.0) << "sources beside the rim give way by less than a texel";
  }
}

/// Positions of a mesh by texture coordinates, slow and plain: the triangle that holds uv.
glm::dvec3 position_mm_at(const SkinMesh& mesh, glm::dvec2 uv) {
  for (std::size_t i = 0; i < mesh.indices.size(); i += 3) {
    const auto t = [&](std::size_t k) { return glm::dvec2(mesh.unwrap[mesh.indices[i + k]]); };
    const glm::dvec2 s = glm::inverse(glm::dmat2(t(1) - t(0), t(2) - t(0))) * (uv - t(0));
    if (s.x < -1e-5 || s.y < -1e-5 || s.x + s.y > 1 + 1e-5) continue;
    const auto p = [&](std::size_t k) {
      return glm::dvec3(mesh.vertices[mesh.indices[i + k]].position_m) * 1e3;
    };
    return p(0) + (p(1) - p(0)) * s.x + (p(2) - p(0)) * s.y;
  }
  return glm::dvec3(1e9);
}

TEST(Gutters, SphereFollowsGreatCircles) {
  constexpr double radius_mm = 10, margin = 0.03;
  const SkinMesh mesh = only_mesh(sphere(radius_mm * 1e-3, 24, margin));
  constexpr int side = 512, width = 14;
  const std::vector<GutterTexel> gutters = build_gutters(mesh, side, width);
  expect_sound(mesh, gutters, side);
  const double chart_size = 1.0 / 3 - 2 * margin, texel_mm = radius_mm * pi / 2 / (chart_size * side);

  std::size_t checked = 0, within_half = 0;
  constexpr std::size_t every = tests::turns(7, 70);
  double worst = 0;
  for (std::size_t i = 0; i < gutters.size(); i += every) {
    const GutterTexel& g = gutters[i];
    ASSERT_NE(g.chart, 0) << "a sphere has no open border";
    const glm::dvec2 uv = glm::dvec2(g.x + 0.5, g.y + 0.5) / double(side);
    const int c = g.chart - 1;
    const glm::dvec2 low = glm::dvec2(c % 3 / 3.0 + margin, c / 3 / 2.0 + margin), high = low + chart_size;

    // From the nearest rim point, in the tangent plane, as far as the metric at the rim says; then along the
    // great circle.
    const glm::dvec2 rim = glm::clamp(uv, low + 1e-6, high - 1e-6),
                     inside = glm::mix(rim, 0.5 * (low + high), 1e-3);

    // Differentiate the position within the chart, mm per unit of the map.
    const double h = 1e-4;
    const auto at = [&](glm::dvec2 q) { return position_mm_at(mesh, q); };
    const glm::dvec2 way(inside.x > 0.5 * (low.x + high.x) ? -h : h,
                         inside.y > 0.5 * (low.y + high.y) ? -h : h);
    const glm::dvec3 dp_du = (at(inside + glm::dvec2(way.x, 0)) - at(inside)) / way.x,
                     dp_dv = (at(inside + glm::dvec2(0, way.y)) - at(inside)) / way.y;

    const glm::dvec3 start = glm::normalize(at(rim));
    glm::dvec3 step = dp_du * (uv - rim).x + dp_dv * (uv - rim).y;
    const double length = glm::length(step);
    step = glm::normalize(step - start * glm::dot(start, step));
    const glm::dvec3 expected =
        radius_mm * (std::cos(length / radius_mm) * start + std::sin(length / radius_mm) * step);

    const glm::dvec3 source =
        glm::normalize(at(glm::dvec2(g.source_x, g.source_y) / double(side))) * radius_mm;
    const double error = glm::distance(source, expected) / texel_mm;
    worst = std::max(worst, error);
    ++checked;
    if (error < 0.5) ++within_half;
  }

  EXPECT_GT(checked, 7000 / every);
  EXPECT_GT(double(within_half) / double(checked), 0.93)
      << "the rest lies beside a rim, where sources give way to stay on covered texels";
  EXPECT_LT(worst, 1.2);
}

TEST(Gutters, SphereChartsKeepTheirOwnSide) {
  const SkinMesh mesh = only_mesh(sphere(0.01, 16, 0.01));
  constexpr int side = 512;  // 10 texels between charts: the nearer one wins although both ask for 40
  const std::vector<GutterTexel> gutters = build_gutters(mesh, side, 40);
  expect_sound(mesh, gutters, side);
  const double size = 1.0 / 3 - 0.02;
  for (const GutterTexel& g : gutters) {
    const glm::dvec2 uv = glm::dvec2(g.x + 0.5, g.y + 0.5) / double(side);
    const auto distance = [&](int c) {
      const glm::dvec2 low(c % 3 / 3.0 + 0.01, c / 3 / 2.0 + 0.01);
      return glm::distance(uv, glm::clamp(uv, low, low + size)) * side;
    };
    double nearest = 1e9;
    for (int c = 0; c < 6; ++c) nearest = std::min(nearest, distance(c));
    ASSERT_NEAR(distance(g.chart - 1), nearest, 1e-3) << g.x << ' ' << g.y;
    ASSERT_LE(nearest, 40 + 1e-3);
  }
}

TEST(Gutters, OpenBordersOnlyFill) {
  const SkinMesh mesh = only_mesh(plane(0.05, glm::dmat2(0.5), {0.25, 0.25}, 3));
  constexpr int side = 64;
  const std::vector<GutterTexel> gutters = build_gutters(mesh, side, 40);
  expect_sound(mesh, gutters, side);
  for (const GutterTexel& g : gutters) {
    EXPECT_EQ(g.chart, 0);
    EXPECT_NEAR(g.source_x, std::clamp(g.x + 0.5, 16.5, 47.5), 1e-6);
    EXPECT_NEAR(g.source_y, std::clamp(g.y + 0.5, 16.5, 47.5), 1e-6);
  }
  EXPECT_EQ(gutters.size(), 4u * 2 * 32 + 4 * 3)
      << "two texels on four sides, three of four within 2 texels at each corner";
}

TEST(Gutters, ListsTexelsOnTheBorderItself) {
  // The border runs through texel centres: whether a device covers them is its own affair.
  const double half = 0.5 / 64;
  const SkinMesh mesh = only_mesh(plane(0.05, glm::dmat2(0.5), {0.25 + half, 0.25 + half}, 3));
  std::size_t on_border = 0;
  for (const GutterTexel& g : build_gutters(mesh, 64, 4))
    if (g.x == 16 && g.y >= 16 && g.y <= 48) ++on_border;
  EXPECT_EQ(on_border, 33u);
}

TEST(Gutters, MirroredHalvesOnTheSameTexels) {
  // Left and right of x = 0 share their coordinates, and lie apart on the map: beyond the seam of each lies
  // the other, mirrored.
  const auto flat = [](glm::dvec2 s) { return glm::dvec3(s.x, s.y, 0); };
  Primitive p;
  append_patch(p, flat, {0, 0}, {40, 40}, glm::dmat2(0.0125, 0, 0, 0.0125), {0.25, 0.25}, 4);
  append_patch(p, flat, {0, 0}, {-40, 40}, glm::dmat2(-0.0125, 0, 0, 0.0125), {0.25, 0.25}, 4);
  const SkinMesh mesh = mesh_from(p);
  EXPECT_EQ(mesh.charts, 2);
  ASSERT_EQ(mesh.layers, 2);
  // The seam is the left edge of both: at 0.25 of the half of the map that each takes, less a margin.
  constexpr int side = 256;
  const double scale = mesh.unwrap_scale.x, first = 0.5 / 64 + 0.25 * scale;
  int seam = 0;
  for (const GutterTexel& g : build_gutters(mesh, side, 10)) {
    const double x = (g.x + 0.5) / side, from_seam = (x > 0.5 ? first + 0.5 : first) - x;
    if (g.chart == 0 || from_seam < 0 || from_seam > 10.0 / side) continue;
    if (g.y < (0.5 / 64 + 0.25 * scale) * side + 1 || g.y > (0.5 / 64 + 0.75 * scale) * side - 1) continue;
    ++seam;
    const double mirrored = (x > 0.5 ? first : first + 0.5) + from_seam;
    EXPECT_NEAR(g.source_x, mirrored * side, 0.02);
    EXPECT_NEAR(g.source_y, g.y + 0.5, 0.02);
  }
  EXPECT_GT(seam, 2 * 9 * 55);
}

TEST(Gutters, SurviveDegenerateTriangles) {
  AssetData scene = sphere(0.01, 8);
  Primitive& p = scene.primitives[0];
  p.indices.insert(p.indices.end(), {0, 0, 1, 5, 5, 5, 0, 1, 2});
  // flat on the map
  for (std::size_t v = 0; v < 30; ++v) p.vertices[v].uv0 = p.vertices[0].uv0;
  // no area in the world
  for (std::size_t v = 100; v < 120; ++v) p.vertices[v].position_m = p.vertices[100].position_m;
  const SkinMesh mesh = only_mesh(scene);
  const std::vector<GutterTexel> gutters = build_gutters(mesh, 128, 20);
  expect_sound(mesh, gutters, 128);
  EXPECT_FALSE(gutters.empty());
  EXPECT_TRUE(build_gutters(SkinMesh{}, 16, 4).empty());
  build_gutters(mesh, 1, 1);
}

TEST(Gutters, GiveUpOnManifoldOverlap) {
  AssetData scene = plane(0.05);
  Primitive& p = scene.primitives[0];
  const std::vector<std::uint32_t> quad = p.indices;
  for (int i = 0; i < 70; ++i) p.indices.insert(p.indices.end(), quad.begin(), quad.end());
  tests::LogLines said;
  EXPECT_TRUE(build_gutters(only_mesh(scene), 64, 4).empty());
  EXPECT_EQ(said.all.size(), 1u);
}

TEST(Gutters, Scan) {
  DERMIS_NEED_SCAN(scan);
  const SkinMesh mesh = only_mesh(*scan);
  const auto begin = std::chrono::steady_clock::now();
  const std::vector<GutterTexel> gutters = build_gutters(mesh, 2048, 40);
  const std::chrono::duration<double> seconds = std::chrono::steady_clock::now() - begin;
  expect_sound(mesh, gutters, 2048);
  std::size_t fill_only = 0;
  for (const GutterTexel& g : gutters) fill_only += g.chart == 0 ? 1 : 0;
  EXPECT_GT(gutters.size(), 100'000u);
  EXPECT_LT(double(fill_only) / double(gutters.size()), 0.001) << "the scan is closed";
  std::printf("scan: %d charts, %zu gutter texels, %zu of them fill only, %.2f s\n", mesh.charts,
              gutters.size(), fill_only, seconds.count());
}

}  // namespace
}  // namespace dermis::scene
