// SPDX-License-Identifier: MIT
// What the test scenes show: their shapes are what they say, closed where light goes through, and mapped.
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

#include "cli/test_scenes/shapes.h"
#include "head/scene/surface/topology.h"
#include "head/scene/surface/unwrap.h"

namespace dermis::cli::test_scenes {
namespace {

std::array<glm::dvec3, 3> corners(const scene::Primitive& p, std::size_t i) {
  return {glm::dvec3(p.vertices[p.indices[i]].position_m),
          glm::dvec3(p.vertices[p.indices[i + 1]].position_m),
          glm::dvec3(p.vertices[p.indices[i + 2]].position_m)};
}

/// Six times the volume that the triangles enclose, positive if they face outwards; m^3.
double volume_m3(const scene::Primitive& p) {
  double sum = 0;
  for (std::size_t i = 0; i < p.indices.size(); i += 3) {
    const auto [a, b, c] = corners(p, i);
    sum += glm::dot(a, glm::cross(b, c)) / 6;
  }
  return sum;
}

std::size_t open_edges(const scene::Primitive& p) {
  const std::vector<glm::vec2> no_uv(p.vertices.size());
  const scene::Topology topology = scene::mesh_topology(p.vertices, no_uv, p.indices);
  return static_cast<std::size_t>(std::count(topology.mate.begin(), topology.mate.end(), scene::no_edge));
}

TEST(Shapes, NormalsAgreeWithTriangles) {
  for (const scene::AssetData& scene :
       {lit_half_plane(LitHalf::below_x, 0), lit_half_plane(LitHalf::below_y, 0.01), nose_on_cheek(),
        thin_lens(), open_curl(), fringe()}) {
    SCOPED_TRACE(scene.name);
    for (const scene::Primitive& p : scene.primitives) {
      ASSERT_EQ(p.indices.size() % 3, 0u);
      int against = 0, counted = 0;
      for (std::size_t i = 0; i < p.indices.size(); i += 3) {
        const auto [a, b, c] = corners(p, i);
        const glm::dvec3 face = glm::cross(b - a, c - a);
        if (glm::length(face) < 1e-13) continue;
        ++counted;
        against += glm::dot(face, glm::dvec3(p.vertices[p.indices[i]].normal)) <= 0;
      }
      EXPECT_GT(counted, 30);
      EXPECT_EQ(against, 0);
      for (const scene::Vertex& v : p.vertices) {
        EXPECT_GE(std::min(v.uv0.x, v.uv0.y), 0);
        EXPECT_LE(std::max(v.uv0.x, v.uv0.y), 1);
      }
    }
  }
}

TEST(Shapes, TheEdgeIsWhereItIsSaid) {
  const scene::AssetData plane = lit_half_plane(LitHalf::below_y, -0.02);
  ASSERT_EQ(plane.primitives.size(), 2u);
  EXPECT_EQ(plane.materials[0].base_colour.x, 1);
  EXPECT_EQ(plane.materials[1].base_colour.x, 0);
  for (const scene::Vertex& v : plane.primitives[0].vertices) EXPECT_LE(v.position_m.y, -0.02f + 1e-6f);
  for (const scene::Vertex& v : plane.primitives[1].vertices) EXPECT_GE(v.position_m.y, -0.02f - 1e-6f);
  for (const scene::Material& m : plane.materials) EXPECT_EQ(m.skin_settings.mix, 1.0f);
}

TEST(Shapes, WhatLightGoesThroughIsClosedAndAsThickAsItIsSaid) {
  const scene::Primitive lens = thin_lens().primitives.front();
  EXPECT_EQ(open_edges(lens), 0u);
  EXPECT_NEAR(volume_m3(lens), 4 * std::numbers::pi / 3 * 0.02 * 0.032 * 0.0015, 2e-8);

  const scene::Primitive curl = open_curl().primitives.front();
  EXPECT_EQ(open_edges(curl), 0u);
  // An arc of 270 degrees between radii of 6 and 9 mm, and two half discs, 50 mm long.
  const double section = 0.75 * std::numbers::pi * (81 - 36) + std::numbers::pi * 1.5 * 1.5;
  EXPECT_NEAR(volume_m3(curl), section * 50 * 1e-9, 0.01 * section * 50 * 1e-9);
}

TEST(Shapes, TheNoseStandsOnTheCheek) {
  const scene::AssetData nose = nose_on_cheek();
  float top = 0;
  for (const scene::Vertex& v : nose.primitives.front().vertices) top = std::max(top, v.position_m.z);
  EXPECT_NEAR(top, 0.028f, 1e-4f);
}

}  // namespace
}  // namespace dermis::cli::test_scenes
