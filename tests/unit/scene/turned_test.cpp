// SPDX-License-Identifier: MIT
#include "head/scene/surface/turned.h"

#include <gtest/gtest.h>

#include <cmath>

#include "head/scene/import/shapes.h"

namespace dermis::scene {
namespace {

SkinMesh sphere_mesh(int subdivisions) { return skin_meshes(sphere(0.1, subdivisions)).front(); }

std::vector<std::uint32_t> neighbours(const std::vector<std::uint32_t>& packed, std::size_t t) {
  return {packed.begin() + packed[t], packed.begin() + packed[t + 1]};
}

TEST(TurnedNeighbours, NoneWhereNormalsAreThoseOfTheFaces) {
  const SkinMesh mesh = sphere_mesh(32);
  const std::vector<std::uint32_t> packed = turned_neighbours(mesh);
  EXPECT_EQ(packed.size(), mesh.triangle_chart.size() + 1);
  for (std::size_t t = 0; t < mesh.triangle_chart.size(); ++t) EXPECT_TRUE(neighbours(packed, t).empty());
}

// All that touch a turned vertex are turned, and are told to all that touch them in turn, across the edges of
// the cube too.
TEST(TurnedNeighbours, ThoseAroundATurnedVertex) {
  SkinMesh mesh = sphere_mesh(32);
  // a corner of the cube: three charts meet
  const glm::vec3 place = mesh.vertices[mesh.indices[0]].position_m;
  for (Vertex& v : mesh.vertices)
    if (glm::distance(v.position_m, place) < 1e-7f)
      v.normal = glm::normalize(glm::cross(v.normal, glm::vec3(0.3f, 0.5f, 0.9f)));

  const std::vector<std::uint32_t> packed = turned_neighbours(mesh);
  std::vector<std::uint32_t> turned;
  const auto touches = [&](std::size_t t, const glm::vec3& p) {
    for (std::size_t k = 0; k < 3; ++k)
      if (glm::distance(mesh.vertices[mesh.indices[3 * t + k]].position_m, p) < 1e-7f) return true;
    return false;
  };

  for (std::uint32_t t = 0; t < mesh.triangle_chart.size(); ++t)
    if (touches(t, place)) turned.push_back(t);
  ASSERT_GE(turned.size(), 3u);

  // Expect of each triangle the turned ones that share a corner with it.
  for (std::uint32_t t = 0; t < mesh.triangle_chart.size(); ++t) {
    std::vector<std::uint32_t> wanted;
    for (const std::uint32_t other : turned) {
      bool meets = false;
      for (std::size_t k = 0; k < 3; ++k)
        meets = meets || touches(t, mesh.vertices[mesh.indices[3 * other + k]].position_m);
      if (meets && other != t) wanted.push_back(other);
    }
    EXPECT_EQ(neighbours(packed, t), wanted) << t;
  }
}

// What no pixel shows, and what would cost the square of its size.
TEST(TurnedNeighbours, HostileMeshesStaySmall) {
  SkinMesh mesh = sphere_mesh(32);
  const std::size_t triangles = mesh.triangle_chart.size();
  for (Vertex& v : mesh.vertices) v.position_m = glm::vec3(0);
  EXPECT_EQ(turned_neighbours(mesh).size(), triangles + 1);
  mesh = sphere_mesh(32);
  const glm::vec3 hub = mesh.vertices[mesh.indices[0]].position_m;
  for (std::size_t t = 0; t < triangles; ++t) mesh.vertices[mesh.indices[3 * t]].position_m = hub;
  for (Vertex& v : mesh.vertices) v.normal = -v.normal;
  const std::vector<std::uint32_t> packed = turned_neighbours(mesh);
  EXPECT_LT(packed.size(), 200 * triangles);
  EXPECT_EQ(neighbours(packed, 0), std::vector<std::uint32_t>{always_kept});
}

}  // namespace
}  // namespace dermis::scene
