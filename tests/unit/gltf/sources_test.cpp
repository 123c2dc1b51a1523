// SPDX-License-Identifier: MIT
// The way back from a scene, and from its skin meshes, to the primitives and accessors of a file.
#include <set>

#include "base/json/document.h"
#include "head/scene/gltf/place.h"
#include "head/scene/surface/unwrap.h"
#include "support.h"
#include "support/thrown.h"

namespace dermis::scene::test {
namespace {

/// A primitive at a node, as a host reads it from the file.
struct HostMesh {
  std::vector<glm::vec3> positions_m;  ///< of all its vertices, placed by its node
  std::vector<glm::vec2> uv0;
  std::vector<std::uint32_t> indices;
};

/// Counts primitives as dermis/asset.h does. Nodes are neither skinned nor morphed, primitives are triangles.
std::vector<HostMesh> host_meshes(const fs::path& file) {
  using namespace gltf;
  const Container container = open_container(file);
  const json::Document json = parse(container.json, file.string());
  const Document document = read_document(json.root(), container, file);
  const std::vector<glm::dmat4> world = world_matrices(document, 1);
  Bytes bytes(document, container);

  std::vector<HostMesh> meshes;
  for (std::size_t n = 0; n < document.nodes.size(); ++n) {
    if (document.nodes[n].mesh < 0) continue;
    for (const MeshPrimitive& primitive : document.meshes[document.nodes[n].mesh].primitives) {
      HostMesh& mesh = meshes.emplace_back();
      DracoMesh draco;
      if (primitive.draco) draco = decode_draco(document, bytes, primitive);
      const auto numbers = [&](const char* name) {
        if (draco.attributes.contains(name)) return draco.attributes[name];
        const auto found = primitive.attributes.find(name);
        return found == primitive.attributes.end() ? std::vector<float>{} : bytes.floats(found->second);
      };

      const std::vector<float> p = numbers("POSITION"), uv = numbers("TEXCOORD_0");
      for (std::size_t i = 0; i + 2 < p.size(); i += 3)
        mesh.positions_m.emplace_back(world[n] * glm::dvec4(p[i], p[i + 1], p[i + 2], 1));
      for (std::size_t i = 0; i + 1 < uv.size(); i += 2) mesh.uv0.emplace_back(uv[i], uv[i + 1]);

      mesh.indices = primitive.draco          ? draco.indices
                     : primitive.indices >= 0 ? bytes.integers(primitive.indices)
                                              : std::vector<std::uint32_t>{};
      for (std::uint32_t v = 0; mesh.indices.size() < mesh.positions_m.size() && primitive.indices < 0; ++v)
        mesh.indices.push_back(v);
    }
  }
  return meshes;
}

void expect_same_vertex(const Vertex& made, const HostMesh& source, std::uint32_t number) {
  ASSERT_LT(number, source.positions_m.size());
  expect_near(made.position_m, source.positions_m[number], 1e-7f);
  EXPECT_EQ(made.uv0, source.uv0.empty() ? glm::vec2(0) : source.uv0[number]);
}

/// Expects that each corner of each triangle names the vertex that the file has there, where mirrored nodes
/// turn triangles round.
void expect_corners(const Primitive& made, const HostMesh& source) {
  ASSERT_EQ(made.indices.size(), source.indices.size());
  bool as_given = true, turned = true;
  for (std::size_t i = 0; i < made.indices.size(); ++i) {
    const std::uint32_t named = source_vertex(made, made.indices[i]);
    as_given &= named == source.indices[i];
    turned &= named == source.indices[i % 3 == 0 ? i : i - i % 3 + 3 - i % 3];
  }
  EXPECT_TRUE(as_given || turned) << made.name;
}

struct Found {
  std::set<int> meshes;
  std::size_t dropped = 0, split = 0;  ///< vertices
};

/// Expects that all that a file's scene says of its sources is so. Shared meshes are only counted.
Found expect_sources(const fs::path& file) {
  const Warnings quiet;
  const AssetData scene = load_gltf(file);
  const std::vector<HostMesh> host = host_meshes(file);
  Found found;
  for (const Primitive& primitive : scene.primitives) {
    EXPECT_TRUE(found.meshes.insert(primitive.source_mesh).second) << "twice: " << primitive.source_mesh;
    if (!primitive.placements.empty()) continue;
    const HostMesh& source = host.at(static_cast<std::size_t>(primitive.source_mesh));
    expect_corners(primitive, source);

    std::set<std::uint32_t> named;
    for (std::uint32_t v = 0; v < primitive.vertices.size(); ++v) {
      expect_same_vertex(primitive.vertices[v], source, source_vertex(primitive, v));
      named.insert(source_vertex(primitive, v));
    }
    EXPECT_EQ(named, std::set(source.indices.begin(), source.indices.end()));
    found.dropped += source.positions_m.size() - named.size();
    found.split += primitive.vertices.size() - named.size();
  }

  for (const SkinMesh& mesh : skin_meshes(scene)) {
    EXPECT_EQ(mesh.sources.size(), mesh.vertices.size());
    for (std::size_t v = 0; v < mesh.sources.size(); ++v)
      expect_same_vertex(mesh.vertices[v], host.at(static_cast<std::size_t>(mesh.sources[v].mesh)),
                         mesh.sources[v].vertex);
  }
  return found;
}

/// Attributes of `count` triangles side by side, `unused` vertices in front of each.
Json triangles(Builder& b, int count, int unused) {
  std::vector<float> positions, uvs;
  for (int t = 0; t < count; ++t) {
    for (int i = 0; i < unused; ++i) {
      positions.insert(positions.end(), {9, 9, 9});
      uvs.insert(uvs.end(), {0.5f, 0.5f});
    }
    const float x = 0.05f * static_cast<float>(t), u = 0.2f * static_cast<float>(t);
    positions.insert(positions.end(), {x, 0, 0, x + 0.04f, 0, 0, x, 0.2f, 0.01f});
    uvs.insert(uvs.end(), {u, 0, u + 0.1f, 0, u, 0.9f});
  }
  return {{"POSITION", b.accessor(positions, "VEC3")}, {"TEXCOORD_0", b.accessor(uvs, "VEC2")}};
}

int indices_past(Builder& b, int count, int unused) {
  std::vector<float> indices;
  for (int t = 0; t < count; ++t)
    for (int k = 0; k < 3; ++k) indices.push_back(static_cast<float>(t * (unused + 3) + unused + k));
  return b.accessor(indices, "SCALAR", 5123);
}

Found sources_of(const Builder& b) {
  const TempFolder folder;
  return expect_sources(b.write(folder.path()));
}

TEST(GltfSources, PrimitivesAreCountedOverTheNodesOfTheFile) {
  Builder b;
  const Json points = triangles(b, 1, 0), few = triangles(b, 2, 3), many = triangles(b, 4, 1);
  const Json plain = triangles(b, 3, 0);
  b.mesh(points);
  b.json["meshes"][0]["primitives"] = {{{"attributes", points}, {"mode", 0}},
                                       {{"attributes", few}, {"indices", indices_past(b, 2, 3)}},
                                       {{"attributes", plain}}};
  b.mesh(many, indices_past(b, 4, 1));

  // Hide the first node, show its mesh at a later one, and turn the tree round: 0 1 2 hidden, then a node
  // without a mesh, then 3 (many), 4 (points), 5 (few), 6 (plain), and 7 8 9 mirrored.
  b.json["nodes"] = {{{"mesh", 0}},
                     {{"children", {4}}, {"translation", {0, 0.1, 0}}},
                     {{"mesh", 1}},
                     {{"mesh", 0}, {"children", {2}}, {"translation", {0.3, 0, 0}}},
                     {{"mesh", 0}, {"scale", {-1, 1, 1}}}};
  b.json["scenes"][0]["nodes"] = {3, 1};
  b.json["materials"] = {{{"name", "skin"}}};
  for (Json& mesh : b.json["meshes"])
    for (Json& primitive : mesh["primitives"]) primitive["material"] = 0;

  const Found found = sources_of(b);
  EXPECT_EQ(found.meshes, (std::set{3, 5, 6, 8, 9}));
  EXPECT_EQ(found.dropped, 6u + 4u + 6u);
}

// A mesh that is not skin is kept once; its vertices come from the file all the same.
TEST(GltfSources, ASharedMeshHasOneNumber) {
  Builder b;
  b.mesh(triangles(b, 2, 3), indices_past(b, 2, 3));
  b.mesh(triangles(b, 1, 0));
  b.json["nodes"] = {{{"mesh", 1}}, {{"mesh", 0}}, {{"mesh", 0}}};
  b.json["scenes"][0]["nodes"] = {0, 1, 2};
  b.json["materials"] = {{{"name", "skin"}}, {{"name", "metal"}}};
  b.json["meshes"][1]["primitives"][0]["material"] = 0;
  b.json["meshes"][0]["primitives"][0]["material"] = 1;
  EXPECT_EQ(sources_of(b).meshes, (std::set{0, 1}));

  const Warnings quiet;
  const AssetData scene = b.load();
  EXPECT_EQ(scene.primitives[1].placements.size(), 2u);
  EXPECT_EQ(scene.primitives[1].source_vertices, (std::vector<std::uint32_t>{3, 4, 5, 9, 10, 11}));
}

TEST(GltfSources, MorePrimitivesThanCanBeCountedAreRefused) {
  gltf::Document document;
  document.file = "many.gltf";
  document.meshes.resize(1);
  document.meshes[0].primitives.resize(1 << 16);
  document.nodes.resize(1 << 15);
  for (gltf::Node& node : document.nodes) node.mesh = 0;
  EXPECT_ERROR(tests::thrown<InputError>([&] { first_source_meshes(document); }),
               "many.gltf: has more than 2147483647 primitives at its nodes");

  document.nodes.back().mesh = -1;
  EXPECT_EQ(first_source_meshes(document).back(), 0x7fff0000);
}

TEST(GltfSources, TheScan) {
  if (const std::string missing = tests::missing_scan({}); !missing.empty()) GTEST_SKIP() << missing;
  EXPECT_EQ(expect_sources(tests::scan_manifest()).meshes, std::set{0});
}

TEST(GltfSources, FilesOfOthers) {
  DERMIS_NEED_ASSETS(root);
  struct Expected {
    const char* name;
    std::size_t meshes;
    bool split;  ///< pictures are mirrored in places
  };
  for (const Expected& file : {Expected{"gltf-valid/head-variants/head-draco.glb", 2, true},
                               {"gltf-valid/head-variants/head-nonindexed.glb", 2, false},
                               {"gltf-valid/head-variants/head-no-uv.glb", 2, false},
                               {"gltf-valid/head-variants/head-sparse-over-base.glb", 2, true},
                               {"gltf-valid/head-variants/head-instanced-mirrored-deep.glb", 5, true},
                               {"makehuman/crowd/mh-crowd-african-man-old-lod0.glb", 2, false}}) {
    SCOPED_TRACE(file.name);
    const Found found = expect_sources(*root / file.name);
    EXPECT_EQ(found.meshes.size(), file.meshes);
    EXPECT_EQ(found.split > 0, file.split);
  }
}

}  // namespace
}  // namespace dermis::scene::test
