// SPDX-License-Identifier: MIT
#include "head/scene/surface/tangents.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "head/scene/import/shapes.h"
#include "scan.h"

namespace dermis::scene {
namespace {

constexpr glm::mat3x2 identity(1, 0, 0, 1, 0, 0);

void expect_orthonormal(const Primitive& primitive) {
  for (const Vertex& v : primitive.vertices) {
    const glm::dvec3 n(v.normal), t(v.tangent);
    ASSERT_NEAR(glm::length(n), 1, 1e-6);
    ASSERT_NEAR(glm::length(t), 1, 1e-6);
    ASSERT_NEAR(glm::dot(n, t), 0, 1e-6);
    ASSERT_EQ(std::abs(v.tangent.w), 1.f);
  }
}

/// Two unit quads in the xy plane that share the edge x = 0; coordinates of the left one mirror those of the
/// right one.
Primitive mirrored_plane() {
  Primitive p;
  for (const float y : {0.f, 1.f})
    for (const float x : {-1.f, 0.f, 1.f}) {
      Vertex v;
      v.position_m = {x, y, 0};
      v.uv0 = {std::abs(x), 1 - y};
      p.vertices.push_back(v);
    }
  p.indices = {0, 1, 4, 0, 4, 3, 1, 2, 5, 1, 5, 4};
  return p;
}

TEST(Tangents, PlaneAsPainted) {
  const Primitive p = plane(0.1, glm::dmat2(1), {}, 3).primitives[0];
  for (const Vertex& v : p.vertices) EXPECT_LT(glm::distance(v.tangent, glm::vec4(1, 0, 0, 1)), 1e-6f);
  EXPECT_EQ(p.vertices.size(), 16u);
}

TEST(Tangents, FollowsTheMapsTransformAndSet) {
  Primitive p = plane(0.1).primitives[0];
  make_tangents(p, glm::mat3x2(-1, 0, 0, 1, 1, 0));  // u mirrored
  for (const Vertex& v : p.vertices) EXPECT_LT(glm::distance(v.tangent, glm::vec4(-1, 0, 0, -1)), 1e-6f);
  make_tangents(p, glm::mat3x2(0, 1, -1, 0, 1, 0));  // (u, v) -> (1 - v, u): the picture turned by 90 degrees
  for (const Vertex& v : p.vertices) EXPECT_LT(glm::distance(v.tangent, glm::vec4(0, 1, 0, 1)), 1e-6f);
  for (Vertex& v : p.vertices) v.uv1 = {v.uv0.y, v.uv0.x};
  make_tangents(p, identity, 1);
  for (const Vertex& v : p.vertices) EXPECT_LT(glm::distance(v.tangent, glm::vec4(0, -1, 0, -1)), 1e-6f);
}

TEST(Tangents, BitangentPointsUpThePicture) {
  Primitive p = plane(0.1, glm::dmat2(0.5, 0.1, 0.4, 0.7)).primitives[0];
  const glm::dvec3 n(p.vertices[0].normal), t(p.vertices[0].tangent);
  const glm::dvec3 up = double(p.vertices[0].tangent.w) * glm::cross(n, t);
  // dP/du and dP/dv of the inverse map; y runs against the lattice's second axis.
  const glm::dmat2 inverse = glm::inverse(glm::dmat2(0.5, 0.1, 0.4, 0.7));
  const glm::dvec3 dp_du(inverse[0].x, -inverse[0].y, 0), dp_dv(inverse[1].x, -inverse[1].y, 0);
  EXPECT_LT(glm::distance(t, glm::normalize(dp_du)), 1e-6);
  EXPECT_LT(glm::dot(up, dp_dv), 0);
}

TEST(Tangents, MirroredPlaneSplitsTheSeam) {
  Primitive p = mirrored_plane();
  make_tangents(p, identity);
  expect_orthonormal(p);
  ASSERT_EQ(p.vertices.size(), 8u);  // the two seam vertices have copies
  for (std::size_t i = 0; i < p.indices.size(); ++i) {
    const bool left = i < 6;
    const Vertex& v = p.vertices[p.indices[i]];
    EXPECT_LT(glm::distance(v.tangent, left ? glm::vec4(-1, 0, 0, -1) : glm::vec4(1, 0, 0, 1)), 1e-6f)
        << "corner " << i;
  }
  const std::size_t once = p.vertices.size();
  make_tangents(p, identity);
  EXPECT_EQ(p.vertices.size(), once) << "a second run has nothing left to split";
}

TEST(Tangents, DegenerateCoordinatesGiveAnyOrthonormalFrame) {
  AssetData scene = sphere(0.1, 4);
  Primitive p = scene.primitives[0];
  for (Vertex& v : p.vertices) v.uv0 = {0.25f, 0.5f};
  make_tangents(p, identity);
  expect_orthonormal(p);
  for (Vertex& v : p.vertices) v.uv0 = {std::numeric_limits<float>::quiet_NaN(), 0.5f};
  make_tangents(p, identity);
  expect_orthonormal(p);
}

TEST(Tangents, SphereFollowsTheCharts) {
  const Primitive p = sphere(0.1, 16).primitives[0];
  expect_orthonormal(p);
  for (const Vertex& v : p.vertices) EXPECT_EQ(v.tangent.w, 1.f);
  // Side +Z: u runs along +X.
  for (std::size_t v = 0; v < 17 * 17; ++v) EXPECT_GT(p.vertices[v].tangent.x, 0.7f);
}

TEST(Tangents, AngleWeightsIgnoreHowAQuadIsCut) {
  // A fan of 1 triangle on one side of the corner, many thin ones on the other: the mean must not lean to the
  // many.
  Primitive p;
  p.vertices.resize(1);
  const auto add = [&](double angle, glm::vec2 uv) {
    Vertex v;
    v.position_m = glm::vec3(glm::dvec3(std::cos(angle), std::sin(angle), 0));
    v.uv0 = uv;
    p.vertices.push_back(v);
  };

  // Left of 90 degrees the picture is turned by -10 degrees, right of it by +10 degrees, both about the
  // corner.
  const double turn = 0.1745;
  const auto uv = [&](double angle, double by) {
    return glm::vec2(glm::dvec2(std::cos(angle + by), -std::sin(angle + by)));
  };

  add(0, uv(0, turn));
  add(1.5707963, uv(1.5707963, turn));
  for (int k = 0; k <= 8; ++k) add(1.5707963 * (1 + k / 8.0), uv(1.5707963 * (1 + k / 8.0), -turn));
  p.indices = {0, 1, 2};
  for (std::uint32_t k = 3; k < 11; ++k) p.indices.insert(p.indices.end(), {0, k, k + 1});

  make_tangents(p, identity);
  EXPECT_NEAR(p.vertices[0].tangent.y, 0, 1e-6);
  EXPECT_GT(p.vertices[0].tangent.x, 0.99f);
}

TEST(Normals, SmoothOverWeldedPositionsAndAreaWeighted) {
  Primitive p = sphere(0.1, 24).primitives[0];
  const std::vector<Vertex> exact = p.vertices;
  for (Vertex& v : p.vertices) v.normal = glm::vec3(0);
  p.vertices[5].normal = glm::vec3(std::numeric_limits<float>::quiet_NaN());
  p.indices.insert(p.indices.end(), {7, 7, 8});  // degenerate
  make_missing_normals(p);
  for (std::size_t v = 0; v < p.vertices.size(); ++v)
    EXPECT_LT(glm::distance(p.vertices[v].normal, exact[v].normal), 0.03f) << v;
  for (std::size_t a = 0; a < p.vertices.size(); ++a)
    for (std::size_t b = 0; b < a; ++b)
      ASSERT_TRUE(p.vertices[a].position_m != p.vertices[b].position_m ||
                  p.vertices[a].normal == p.vertices[b].normal)
          << a << ' ' << b;
}

TEST(Normals, KeepsGivenOnesButMakesThemUnit) {
  Primitive p = plane(1).primitives[0];
  p.vertices[0].normal = {3, 0, 4};
  p.vertices[1].normal = {1e-30f, 0, 0};
  make_missing_normals(p);
  EXPECT_LT(glm::distance(p.vertices[0].normal, glm::vec3(0.6f, 0, 0.8f)), 1e-6f);
  EXPECT_LT(glm::distance(p.vertices[1].normal, glm::vec3(1, 0, 0)), 1e-6f);
}

TEST(Normals, WithoutAreaStillUnit) {
  Primitive p;
  p.vertices.resize(3);
  for (Vertex& v : p.vertices) v.normal = glm::vec3(0);
  p.indices = {0, 1, 2};
  make_missing_normals(p);
  for (const Vertex& v : p.vertices) EXPECT_EQ(v.normal, glm::vec3(0, 0, 1));
}

TEST(Tangents, Scan) {
  DERMIS_NEED_SCAN(scan);
  const Primitive& p = scan->primitives[0];
  expect_orthonormal(p);
  double area = 0, mirrored = 0;
  for (std::size_t i = 0; i < p.indices.size(); i += 3) {
    const auto at = [&](std::size_t k) { return glm::dvec3(p.vertices[p.indices[i + k]].position_m); };
    const double a = glm::length(glm::cross(at(1) - at(0), at(2) - at(0)));
    area += a;
    if (p.vertices[p.indices[i]].tangent.w < 0) mirrored += a;
  }
  EXPECT_NEAR(mirrored / area, 0.2, 0.05)
      << "the scan's notes: about a fifth of the area has mirrored coordinates";
}

}  // namespace
}  // namespace dermis::scene
