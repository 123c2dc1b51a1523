// SPDX-License-Identifier: MIT
#include "head/scene/surface/unwrap.h"

#include <algorithm>
#include <map>

#include "base/core/assert.h"
#include "head/scene/surface/chart_layers.h"
#include "head/scene/surface/topology.h"
#include "head/scene/surface/unwrap_fit.h"

namespace dermis::scene {
namespace {

void append_primitive(SkinMesh& mesh, const Primitive& primitive, std::uint32_t number) {
  DERMIS_ASSERT_EQ(primitive.indices.size() % 3, std::size_t{0});
  const auto base = static_cast<std::uint32_t>(mesh.vertices.size());
  mesh.vertices.insert(mesh.vertices.end(), primitive.vertices.begin(), primitive.vertices.end());
  if (!primitive.source_vertices.empty())
    DERMIS_ASSERT_EQ(primitive.source_vertices.size(), primitive.vertices.size());
  for (std::uint32_t v = 0; v < primitive.vertices.size(); ++v) {
    mesh.sources.push_back({primitive.source_mesh, source_vertex(primitive, v)});
    mesh.origins.push_back({number, v});
  }
  mesh.primitives.push_back({number, static_cast<std::uint32_t>(mesh.indices.size() / 3)});
  for (const std::uint32_t index : primitive.indices) mesh.indices.push_back(base + index);
  mesh.triangle_material.insert(mesh.triangle_material.end(), primitive.indices.size() / 3,
                                primitive.material);
}

/// Appends a copy of a vertex at a place on the map, and returns its number.
std::uint32_t append_copy(SkinMesh& mesh, std::uint32_t vertex, const glm::vec2& unwrap) {
  mesh.vertices.push_back(Vertex(mesh.vertices[vertex]));
  mesh.sources.push_back(SourceVertex(mesh.sources[vertex]));
  mesh.origins.push_back(PrimitiveVertex(mesh.origins[vertex]));
  mesh.unwrap.push_back(unwrap);
  return static_cast<std::uint32_t>(mesh.vertices.size() - 1);
}

/// Gives triangles that are not on the map vertices of their own, all at one point: without area there they
/// cover no texel, have no neighbours and no metric.
void take_off_the_map(SkinMesh& mesh, const std::vector<bool>& on_map) {
  std::vector<bool> shared(mesh.vertices.size(), false);
  for (std::size_t i = 0; i < mesh.indices.size(); ++i)
    if (on_map[i / 3]) shared[mesh.indices[i]] = true;

  std::vector<std::uint32_t> copy(mesh.vertices.size(), no_edge);
  for (std::size_t i = 0; i < mesh.indices.size(); ++i) {
    if (on_map[i / 3]) continue;
    const std::uint32_t vertex = mesh.indices[i];
    if (!shared[vertex]) {
      mesh.unwrap[vertex] = glm::vec2(0);
      continue;
    }
    if (copy[vertex] == no_edge) copy[vertex] = append_copy(mesh, vertex, glm::vec2(0));
    mesh.indices[i] = copy[vertex];
  }
}

/// Numbers the charts that are on the map from 0 in order of first appearance; the rest share one number.
void number_charts(std::vector<std::uint32_t>& chart, const std::vector<bool>& on_map) {
  std::vector<std::uint32_t> number(chart.size(), no_edge);
  std::uint32_t charts = 0;
  for (std::size_t t = 0; t < chart.size(); ++t) {
    if (!on_map[t]) {
      chart[t] = no_edge - 1;
      continue;
    }
    std::uint32_t& n = number[chart[t]];
    if (n == no_edge) n = charts++;
    chart[t] = n;
  }
}

/// Assigns charts, one per vertex, so that metric and chart id can be vertex attributes. Returns the number
/// of each triangle's, as number_charts() has it.
std::vector<std::uint32_t> assign_charts(SkinMesh& mesh, const std::vector<bool>& on_map) {
  const Topology topology = mesh_topology(mesh.vertices, mesh.unwrap, mesh.indices);
  std::vector<std::uint32_t> chart = find_charts(topology, mesh.unwrap, mesh.indices);
  number_charts(chart, on_map);
  for (std::size_t t = 0; t < chart.size(); ++t) {
    if (on_map[t]) mesh.charts = std::max(mesh.charts, static_cast<int>(chart[t]) + 1);
    mesh.triangle_chart.push_back(on_map[t] ? static_cast<std::uint16_t>(1 + chart[t] % max_chart_id)
                                            : no_chart);
  }

  std::vector<std::uint32_t> owner(mesh.vertices.size(), no_edge);
  std::map<std::pair<std::uint32_t, std::uint32_t>, std::uint32_t> copies;  // (vertex, chart) -> copy
  for (std::size_t i = 0; i < mesh.indices.size(); ++i) {
    std::uint32_t& index = mesh.indices[i];
    if (owner[index] == no_edge) owner[index] = chart[i / 3];
    if (owner[index] == chart[i / 3]) continue;
    const auto [entry, is_new] =
        copies.try_emplace({index, chart[i / 3]}, static_cast<std::uint32_t>(mesh.vertices.size()));
    if (is_new) append_copy(mesh, index, glm::vec2(mesh.unwrap[index]));
    index = entry->second;
  }
  return chart;
}

}  // namespace

std::vector<SkinMesh> skin_meshes(const AssetData& scene) {
  std::vector<SkinMesh> meshes;
  std::map<SkinMeshKey, std::size_t> mesh_of_key;
  for (const Primitive& primitive : scene.primitives) {
    if (!scene.materials.at(static_cast<std::size_t>(primitive.material)).skin || primitive.indices.empty())
      continue;

    const auto [entry, is_new] = mesh_of_key.try_emplace(skin_mesh_key(primitive), meshes.size());
    if (is_new) {
      meshes.emplace_back();
      meshes.back().name = primitive.name;
      meshes.back().key = entry->first;
    }
    append_primitive(meshes[entry->second], primitive,
                     static_cast<std::uint32_t>(&primitive - scene.primitives.data()));
  }

  for (SkinMesh& mesh : meshes) {
    const std::vector<bool> on_map = fit_unwrap(mesh);
    take_off_the_map(mesh, on_map);
    lay_charts_apart(mesh, assign_charts(mesh, on_map));
    compute_metric(mesh, scene.mm_per_unit);
  }
  return meshes;
}

bool has_chartless(const SkinMesh& mesh) {
  return std::find(mesh.triangle_chart.begin(), mesh.triangle_chart.end(), no_chart) !=
         mesh.triangle_chart.end();
}

}  // namespace dermis::scene
