// SPDX-License-Identifier: MIT
#include "moved.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "head/scene/placement.h"
#include "head/scene/rig/rig.h"

namespace dermis::scene::test {

Compared compare(const AssetData& scene, const Points& expected) {
  Compared c;
  glm::dvec3 low(1e9), high(-1e9);
  for (const Primitive& primitive : scene.primitives)
    for (std::uint32_t v = 0; v < primitive.vertices.size(); ++v) {
      const glm::dvec3 p(world_position_m(primitive, 0, v));
      low = glm::min(low, p);
      high = glm::max(high, p);
      if (!primitive.placements.empty()) continue;
      const PosedByHand::Point& e =
          expected.at(static_cast<std::size_t>(primitive.source_mesh)).at(source_vertex(primitive, v));
      c.farthest = std::max(c.farthest, glm::distance(p, glm::dvec3(e[0], e[1], e[2])));
    }
  c.size = glm::distance(low, high);
  return c;
}

Apart apart(const AssetData& a, const AssetData& b) {
  Apart most;
  EXPECT_EQ(a.primitives.size(), b.primitives.size());
  for (std::size_t i = 0; i < a.primitives.size(); ++i) {
    EXPECT_EQ(a.primitives[i].vertices.size(), b.primitives[i].vertices.size());
    for (std::uint32_t v = 0; v < a.primitives[i].vertices.size(); ++v) {
      const Vertex &x = a.primitives[i].vertices[v], &y = b.primitives[i].vertices[v];
      most.positions = std::max(most.positions, double{glm::distance(x.position_m, y.position_m)});
      most.normals = std::max(most.normals, double{glm::distance(x.normal, y.normal)});
      most.tangents = std::max(most.tangents, double{glm::distance(x.tangent, y.tangent)});
    }
  }
  return most;
}

}  // namespace dermis::scene::test
