// SPDX-License-Identifier: MIT
// The way back from a skin mesh to the arrays of a host: whatever is dropped, split or joined on the way.
#include <array>
#include <cmath>
#include <map>
#include <set>

#include "head/scene/arrays/from_arrays.h"
#include "head/scene/surface/unwrap.h"
#include "support.h"

namespace dermis::scene::test {
namespace {

constexpr int head_node = 3;
constexpr std::uint32_t side = 4, columns = side + 1;

/// A bumpy sheet 0.2 m high of 4 x 4 quads, without normals and tangents.
OwnedMesh sheet() {
  OwnedMesh mesh;
  for (std::uint32_t y = 0; y < columns; ++y)
    for (std::uint32_t x = 0; x < columns; ++x) {
      const float u = static_cast<float>(x) / side, v = static_cast<float>(y) / side;
      mesh.positions_m.push_back({0.2f * u, 0.2f * v, 0.01f * static_cast<float>((7 * x + 3 * y) % 5)});
      mesh.uv0.push_back({0.1f + 0.8f * u, 0.9f - 0.8f * v});
    }
  for (std::uint32_t y = 0; y < side; ++y)
    for (std::uint32_t x = 0; x < side; ++x) {
      const std::uint32_t a = y * columns + x, b = a + columns;
      mesh.indices.insert(mesh.indices.end(), {a, a + 1, b + 1, a, b + 1, b});
    }
  return mesh;
}

/// The sheet whose left half shows the picture of the right half in a mirror.
OwnedMesh mirrored_sheet() {
  OwnedMesh mesh = sheet();
  for (auto& uv : mesh.uv0) uv[0] = std::abs(uv[0] - 0.5f);
  return mesh;
}

/// Adds normals and tangents, which are then taken as they are.
void add_frames(OwnedMesh& mesh) {
  mesh.normals.assign(mesh.positions_m.size(), {0, 0, 1});
  mesh.tangents.assign(mesh.positions_m.size(), {1, 0, 0, 1});
}

/// Arrays of meshes, each a head of skin until it is told otherwise.
AssetArrays heads(const std::vector<OwnedMesh>& meshes) {
  AssetArrays given;
  given.name = "heads";
  given.materials.resize(2);
  given.materials[0].name = "face";
  given.materials[0].skin = true;
  given.materials[1].name = "cloth";
  for (const OwnedMesh& mesh : meshes) {
    given.meshes.push_back({.name = "sheet", .material = 0, .node = head_node});
    mesh.lend(given.meshes.back());
  }
  return given;
}

/// Expects that each corner of each triangle names the vertex that the arrays have there, and that each
/// vertex is like the one that it names. Returns the number of vertices that were split off.
std::size_t expect_sources(const AssetArrays& given) {
  std::map<int, std::vector<SourceVertex>> corners;  // by node, in the order of the meshes
  for (std::size_t i = 0; i < given.meshes.size(); ++i) {
    if (given.meshes[i].material != 0) continue;
    for (const std::uint32_t index : given.meshes[i].indices)
      corners[given.meshes[i].node].push_back({static_cast<int>(i), index});
  }

  std::size_t split_off = 0;
  const Warnings quiet;
  const std::vector<SkinMesh> skin = skin_meshes(scene_from_arrays(given));
  EXPECT_EQ(skin.size(), corners.size());
  for (const SkinMesh& mesh : skin) {
    EXPECT_EQ(mesh.sources.size(), mesh.vertices.size());
    if (mesh.sources.size() != mesh.vertices.size()) continue;

    std::vector<SourceVertex> named;
    for (const std::uint32_t index : mesh.indices) named.push_back(mesh.sources[index]);
    EXPECT_TRUE(named == corners[mesh.key.node]);

    std::set<std::pair<int, std::uint32_t>> different;
    for (std::size_t v = 0; v < mesh.vertices.size(); ++v) {
      const AssetMesh& source = given.meshes.at(static_cast<std::size_t>(mesh.sources[v].mesh));
      const std::array<float, 3>& position_m = source.positions_m[mesh.sources[v].vertex];
      const std::array<float, 2>& uv0 = source.uv0[mesh.sources[v].vertex];
      EXPECT_EQ(mesh.vertices[v].position_m, glm::vec3(position_m[0], position_m[1], position_m[2])) << v;
      EXPECT_EQ(mesh.vertices[v].uv0, glm::vec2(uv0[0], uv0[1])) << v;
      different.emplace(mesh.sources[v].mesh, mesh.sources[v].vertex);
    }
    split_off += mesh.vertices.size() - different.size();
  }
  return split_off;
}

/// Vertices that no triangle uses, before, between and behind the others.
OwnedMesh with_gaps(const OwnedMesh& mesh) {
  OwnedMesh out;
  std::vector<std::uint32_t> number;
  for (std::size_t i = 0; i < mesh.positions_m.size(); ++i) {
    for (std::size_t repeats = i % 3 == 0 ? 2 : 1; repeats > 0; --repeats) {
      out.positions_m.push_back(mesh.positions_m[i]);
      out.uv0.push_back(mesh.uv0[i]);
      out.positions_m.back()[1] += 0.5f * static_cast<float>(repeats - 1);
    }
    number.push_back(static_cast<std::uint32_t>(out.positions_m.size() - 1));
  }
  out.positions_m.push_back({});
  out.uv0.push_back({});
  for (const std::uint32_t index : mesh.indices) out.indices.push_back(number[index]);
  return out;
}

TEST(ArraysSources, AllVerticesInTheirOrder) {
  const std::vector<OwnedMesh> meshes{sheet()};
  EXPECT_EQ(expect_sources(heads(meshes)), 0u);
  EXPECT_TRUE(scene_from_arrays(heads(meshes)).primitives[0].source_vertices.empty()) << "takes no memory";
}

TEST(ArraysSources, UnusedVerticesAreLeftOut) {
  const std::vector<OwnedMesh> meshes{with_gaps(sheet())};
  EXPECT_EQ(expect_sources(heads(meshes)), 0u);
}

// Tangents are made: vertices between picture and mirror picture are split before charts are.
TEST(ArraysSources, VerticesSplitByTheirTangents) {
  const std::vector<OwnedMesh> whole{mirrored_sheet()}, gaps{with_gaps(mirrored_sheet())};
  EXPECT_EQ(scene_from_arrays(heads(whole)).primitives[0].vertices.size(), (columns + 1) * columns);
  EXPECT_EQ(expect_sources(heads(whole)), columns);
  EXPECT_EQ(expect_sources(heads(gaps)), columns);
}

// Tangents are given: the same vertices are split because they lie on two charts.
TEST(ArraysSources, VerticesSplitByTheirCharts) {
  std::vector<OwnedMesh> meshes{mirrored_sheet()};
  add_frames(meshes[0]);
  EXPECT_EQ(scene_from_arrays(heads(meshes)).primitives[0].vertices.size(), columns * columns);
  EXPECT_EQ(expect_sources(heads(meshes)), columns);
}

// Triangles between three vertices of a row: they have area on the skin, and none on the map.
TEST(ArraysSources, VerticesSplitOffTheMap) {
  OwnedMesh mesh = sheet();
  for (const std::uint32_t row : {columns, 2 * columns})
    mesh.indices.insert(mesh.indices.begin(), {row, row + 1, row + 2});
  const std::vector<OwnedMesh> meshes{with_gaps(mesh)};
  EXPECT_EQ(expect_sources(heads(meshes)), 6u);
}

// Two meshes of one head with a mesh of cloth between them, and a second head.
TEST(ArraysSources, MeshesOfAHeadAreTold) {
  const std::vector<OwnedMesh> meshes{with_gaps(sheet()), sheet(), mirrored_sheet(), sheet()};
  AssetArrays given = heads(meshes);
  given.meshes[1].material = 1;
  given.meshes[3].node = head_node + 1;
  EXPECT_EQ(expect_sources(given), columns);
}

}  // namespace
}  // namespace dermis::scene::test
