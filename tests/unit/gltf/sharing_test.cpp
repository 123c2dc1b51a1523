// SPDX-License-Identifier: MIT
// Nodes that share a mesh share its memory; and in the world they stand where they would stand without that.
#include <glm/gtc/matrix_transform.hpp>

#include "head/scene/framing.h"
#include "head/scene/placement.h"
#include "support.h"
#include "support/written_out.h"

namespace dermis::scene::test {

namespace {

/// Two faces of a prism with normals and coordinates, away from its origin by `away`; returns the mesh.
int add_prism(Builder& b, float away = 0) {
  const int position = b.accessor({away, 0, 0, away + 0.2f, 0, 0, away, 0.2f, 0, away, 0, 0.1f}, "VEC3");
  const int normal = b.accessor({0, 0, 1, 0, 0, 1, 0, 0.6f, 0.8f, 1, 0, 0}, "VEC3");
  const int uv = b.accessor({0, 0, 1, 0, 0, 1, 1, 1}, "VEC2");
  const int indices = b.accessor({0, 1, 2, 0, 3, 1}, "SCALAR", 5123);
  return b.mesh({{"POSITION", position}, {"NORMAL", normal}, {"TEXCOORD_0", uv}}, indices);
}

/// A file whose nodes show the prism, moved, turned, stretched and mirrored; `distinct`: each node has a mesh
/// of its own that reads the same data.
Builder prisms(int count, bool distinct, float away = 0, const Json& dermis = {{"skin", false}}) {
  Builder b;
  const int mesh = add_prism(b, away);
  b.json["materials"] = {{{"name", "metal"}, {"extras", {{"dermis", dermis}}}}};
  b.json["meshes"][0]["primitives"][0]["material"] = 0;
  b.json["nodes"] = Json::array();
  b.json["scenes"][0]["nodes"] = Json::array();

  for (int i = 0; i < count; ++i) {
    const double angle = 0.7 * i;
    Json node = {{"mesh", mesh},
                 {"name", "prism " + std::to_string(i)},
                 {"translation", {0.3 * i - double(away), 0.1 * i, -0.2}},
                 {"rotation", {0.6 * std::sin(angle), 0.8 * std::sin(angle), 0, std::cos(angle)}},
                 {"scale", {i % 3 == 1 ? -1.5 : 1.0, 1.0, 0.5}}};

    if (distinct && i > 0) {
      b.json["meshes"].push_back(b.json["meshes"][0]);
      node["mesh"] = i;
    }
    b.json["nodes"].push_back(node);
    b.json["scenes"][0]["nodes"].push_back(i);
  }

  return b;
}

void expect_same_world(const AssetData& shared, const AssetData& distinct, float tolerance_m) {
  const std::vector<Primitive> all = written_out(shared);
  ASSERT_EQ(all.size(), distinct.primitives.size());
  for (std::size_t p = 0; p < all.size(); ++p) {
    const Primitive &a = all[p], &b = distinct.primitives[p];
    EXPECT_EQ(a.node, b.node);
    ASSERT_EQ(a.indices.size(), b.indices.size());
    for (std::size_t i = 0; i < a.indices.size(); ++i) {
      const Vertex &x = a.vertices[a.indices[i]], &y = b.vertices[b.indices[i]];
      expect_near(x.position_m, y.position_m, tolerance_m);
      expect_near(x.normal, y.normal);
      // made in the mesh's own coordinates, as tools that bake normal maps do, then turned with it
      EXPECT_NEAR(glm::length(glm::vec3(x.tangent)), 1, 1e-5);
      EXPECT_NEAR(glm::dot(glm::vec3(x.tangent), x.normal), 0, 1e-5);
      EXPECT_EQ(x.tangent.w, y.tangent.w);
      EXPECT_EQ(x.uv0, y.uv0);
    }
  }
}

}  // namespace

TEST(GltfSharing, ManyNodesOfAMeshAreOnePrimitiveWithPlaces) {
  const Warnings quiet;
  const AssetData scene = prisms(2000, false).load();
  ASSERT_EQ(scene.primitives.size(), 1u);
  EXPECT_EQ(scene.primitives[0].placements.size(), 2000u);
  EXPECT_EQ(copies_of(scene.primitives[0]), 2000u);
  EXPECT_LE(scene.primitives[0].vertices.size(), 8u);
  EXPECT_EQ(scene.primitives[0].placements[1999].node, 1999);
}

TEST(GltfSharing, TheWorldIsTheSameAsWithoutSharing) {
  const Warnings quiet;
  const AssetData shared = prisms(7, false).load(), distinct = prisms(7, true).load();
  EXPECT_EQ(shared.primitives.size(), 1u);
  expect_same_world(shared, distinct, 1e-6f);

  const auto all = [](const Primitive&) { return true; };
  const BoundingSphere a = bounding_sphere(shared, all), b = bounding_sphere(distinct, all);
  expect_near(a.centre_m, b.centre_m, 1e-6f);
  EXPECT_NEAR(a.radius_m, b.radius_m, 1e-6);
  EXPECT_NEAR(skin_bounds(shared).sphere.radius_m, skin_bounds(distinct).sphere.radius_m, 1e-6);
}

// A mesh that its file keeps a kilometre away from its origin, with nodes that bring it back: floats of that
// size step by 0.06 mm, and no rounding may come on top.
TEST(GltfSharing, AMeshFarFromItsOriginKeepsItsShape) {
  const Warnings quiet;
  const AssetData shared = prisms(3, false, 1000).load();
  ASSERT_EQ(shared.primitives.size(), 1u);
  for (const Vertex& v : shared.primitives[0].vertices) EXPECT_LT(glm::length(v.position_m), 1);
  expect_same_world(shared, prisms(3, true, 1000).load(), 1e-6f);
}

TEST(GltfSharing, MirroredPlacesWindOutwards) {
  const Warnings quiet;
  const AssetData scene = prisms(6, false).load();
  const Primitive& p = scene.primitives.at(0);
  for (std::size_t copy = 0; copy < p.placements.size(); ++copy) {
    EXPECT_EQ(p.placements[copy].mirrored, copy % 3 == 1);
    const auto corner = world_corners(p, copy, 0);
    const glm::vec3 a = world_position_m(p, copy, corner[0]), b = world_position_m(p, copy, corner[1]),
                    c = world_position_m(p, copy, corner[2]);
    EXPECT_GT(glm::dot(glm::cross(b - a, c - a), world_vertex(p, copy, corner[0]).normal), 0) << copy;
  }
}

TEST(GltfSharing, SkinHasAMeshForEachNode) {
  const Warnings quiet;
  const AssetData scene = prisms(5, false, 0, {{"skin", true}}).load();
  ASSERT_EQ(scene.primitives.size(), 5u);
  for (const Primitive& p : scene.primitives) EXPECT_TRUE(p.placements.empty());
}

TEST(GltfSharing, MoreNodesOfSkinThanCanBeLitAreRefused) {
  const Warnings quiet;
  EXPECT_ERROR(prisms(1025, false, 0, {{"skin", true}}).error(), "1025 nodes of skin");
  EXPECT_EQ(prisms(1024, false, 0, {{"skin", true}}).load().primitives.size(), 1024u);
}

TEST(GltfSharing, NodesThatMorphHaveMeshesOfTheirOwn) {
  const Warnings quiet;
  Builder b = prisms(4, false);
  const int delta = b.accessor({0, 0.1f, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0}, "VEC3");
  b.json["meshes"][0]["primitives"][0]["targets"] = {{{"POSITION", delta}}};
  b.json["nodes"][2]["weights"] = {1};
  const AssetData scene = b.load();
  // A pose may give each node weights of its own.
  ASSERT_EQ(scene.primitives.size(), 4u);
  for (std::size_t i = 0; i < 4; ++i) {
    EXPECT_TRUE(scene.primitives[i].placements.empty());
    EXPECT_EQ(scene.primitives[i].node, static_cast<int>(i));
  }
}

TEST(GltfSharing, APlaceBeyondTheLimitIsRefused) {
  Builder b = prisms(3, false);
  b.json["nodes"][1]["translation"] = {2e6, 0, 0};
  EXPECT_ERROR(b.error(), "m from the origin");
}

TEST(GltfSharing, OneWarningForAllMeshes) {
  Builder b = prisms(501, true, 0, {{"skin", true}});
  for (Json& mesh : b.json["meshes"]) mesh["primitives"][0]["attributes"].erase("TEXCOORD_0");
  const Warnings warnings;
  b.load();
  const std::string all = warnings.all();
  EXPECT_NE(all.find("501"), std::string::npos) << all;
  EXPECT_NE(all.find("'prism 0', 'prism 1', 'prism 2'"), std::string::npos) << all;
  EXPECT_EQ(all.find("'prism 3'"), std::string::npos) << all;
}

}  // namespace dermis::scene::test
