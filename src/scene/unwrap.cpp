// SPDX-License-Identifier: MIT
#include "scene/unwrap.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <unordered_map>

#include "core/assert.h"
#include "core/warnings.h"
#include "scene/topology.h"

namespace dermis::scene {
namespace {

void append_primitive(SkinMesh& mesh, const Primitive& primitive) {
  DERMIS_ASSERT_EQ(primitive.indices.size() % 3, std::size_t{0});
  const auto base = static_cast<std::uint32_t>(mesh.vertices.size());
  mesh.vertices.insert(mesh.vertices.end(), primitive.vertices.begin(), primitive.vertices.end());
  for (const std::uint32_t index : primitive.indices) mesh.indices.push_back(base + index);
  mesh.triangle_material.insert(mesh.triangle_material.end(), primitive.indices.size() / 3,
                                primitive.material);
}

struct AxisFit {
  double scale = 1, offset = 0;
  bool fitted = false;
};

/// Brings [low, high] into [0, 1]: not at all, by whole tiles, or by an affine fit.
AxisFit fit_axis(double low, double high) {
  if (low >= 0 && high <= 1) return {};
  const double tile = std::floor(low);
  if (high - tile <= 1) return {1, -tile, false};
  return {1 / (high - low), -low / (high - low), true};
}

void fit_unwrap(SkinMesh& mesh) {
  glm::dvec2 low(1e300), high(-1e300);
  for (const std::uint32_t index : mesh.indices) {
    const glm::dvec2 uv(mesh.vertices[index].uv0);
    if (!std::isfinite(uv.x) || !std::isfinite(uv.y)) continue;
    low = glm::min(low, uv), high = glm::max(high, uv);
  }
  if (!(low.x <= high.x)) low = high = glm::dvec2(0);
  const AxisFit u = fit_axis(low.x, high.x), v = fit_axis(low.y, high.y);
  mesh.unwrap_scale = {u.scale, v.scale};
  mesh.unwrap_offset = {u.offset, v.offset};
  if (u.fitted || v.fitted) {
    mesh.unwrap_note =
        fmt::format("texture coordinates span u {:.4g} to {:.4g}, v {:.4g} to {:.4g}: scaled to fit 0..1",
                    low.x, high.x, low.y, high.y);
    // A rounding error outside costs nothing; a second tile costs sharpness, and tiles that were meant to
    // coincide now lie side by side.
    if (std::min(u.scale, v.scale) < 0.999)
      warn_of(
          "skin: texture coordinates lie outside 0..1 and are scaled to fit; maps hold fewer texels per mm",
          mesh.name,
          fmt::format("skin '{}': {}; the map holds fewer texels per mm", mesh.name, mesh.unwrap_note));
  } else if (u.offset != 0 || v.offset != 0) {
    mesh.unwrap_note = fmt::format("texture coordinates moved by {:+g}, {:+g} tiles", u.offset, v.offset);
  }
  mesh.unwrap.reserve(mesh.vertices.size());
  for (const Vertex& vertex : mesh.vertices) {
    const glm::dvec2 uv = glm::dvec2(vertex.uv0) * mesh.unwrap_scale + mesh.unwrap_offset;
    const bool valid = std::isfinite(uv.x) && std::isfinite(uv.y);
    mesh.unwrap.emplace_back(valid ? glm::clamp(uv, glm::dvec2(0), glm::dvec2(1)) : glm::dvec2(0));
  }
}

/// Charts, and one chart per vertex: metric and chart id can then be vertex attributes.
void assign_charts(SkinMesh& mesh) {
  const Topology topology = mesh_topology(mesh.vertices, mesh.unwrap, mesh.indices);
  const std::vector<std::uint32_t> chart = find_charts(topology, mesh.unwrap, mesh.indices);
  mesh.charts = chart.empty() ? 0 : static_cast<int>(*std::max_element(chart.begin(), chart.end())) + 1;
  for (const std::uint32_t c : chart)
    mesh.triangle_chart.push_back(static_cast<std::uint16_t>(1 + c % max_chart_id));

  std::vector<std::uint32_t> owner(mesh.vertices.size(), no_edge);
  std::map<std::pair<std::uint32_t, std::uint32_t>, std::uint32_t> copies;  // (vertex, chart) -> copy
  for (std::size_t i = 0; i < mesh.indices.size(); ++i) {
    std::uint32_t& index = mesh.indices[i];
    if (owner[index] == no_edge) owner[index] = chart[i / 3];
    if (owner[index] == chart[i / 3]) continue;
    const auto [entry, is_new] =
        copies.try_emplace({index, chart[i / 3]}, static_cast<std::uint32_t>(mesh.vertices.size()));
    if (is_new) {
      mesh.vertices.push_back(Vertex(mesh.vertices[index]));
      mesh.unwrap.push_back(glm::vec2(mesh.unwrap[index]));
    }
    index = entry->second;
  }
}

}  // namespace

std::vector<SkinMesh> skin_meshes(const Scene& scene) {
  std::vector<SkinMesh> meshes;
  std::map<int, std::size_t> mesh_of_node;
  for (const Primitive& primitive : scene.primitives) {
    // Without texture coordinates there is nothing to unwrap: drawn as any other material.
    if (!scene.materials.at(static_cast<std::size_t>(primitive.material)).skin || !primitive.has_uv ||
        primitive.indices.empty())
      continue;
    const auto [entry, is_new] = mesh_of_node.try_emplace(primitive.node, meshes.size());
    if (is_new) {
      meshes.emplace_back();
      meshes.back().name = primitive.name;
      meshes.back().node = primitive.node;
    }
    append_primitive(meshes[entry->second], primitive);
  }
  for (SkinMesh& mesh : meshes) {
    fit_unwrap(mesh);
    assign_charts(mesh);
    compute_metric(mesh, scene.mm_per_unit);
  }
  return meshes;
}

}  // namespace dermis::scene
