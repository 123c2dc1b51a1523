// SPDX-License-Identifier: MIT
#include "head/scene/surface/chart_layers.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <map>
#include <numeric>
#include <utility>
#include <vector>

#include "head/scene/surface/coverage.h"
#include "head/scene/surface/topology.h"
#include "head/scene/surface/union_find.h"
#include "head/scene/surface/unwrap_fit.h"

namespace dermis::scene {
namespace {

constexpr int side = 512;  // cells of the map
constexpr double few_overlap = 0.01;
constexpr double shared_at_borders = 0.02;  // of the cells of a chart: charts may touch

using Cells = std::vector<std::uint32_t>;

using Corner = std::pair<std::uint32_t, std::uint32_t>;  // place, texture coordinates

// Returns the corners of a triangle, the least first, in the order in which it winds.
std::array<Corner, 3> corners_of(const SkinMesh& mesh, const Topology& topology, std::size_t triangle) {
  std::array<Corner, 3> corners;
  for (std::size_t k = 0; k < 3; ++k) {
    const std::uint32_t vertex = mesh.indices[3 * triangle + k];
    corners[k] = {topology.position_id[vertex], topology.uv_id[vertex]};
  }
  std::rotate(corners.begin(), std::ranges::min_element(corners), corners.end());
  return corners;
}

// Joins charts that have triangles in common, which a file has twice: they show the same light, and stay
// together. One that faces the other way is another triangle.
UnionFind twins_of(const SkinMesh& mesh, std::span<const std::uint32_t> chart) {
  const Topology topology = mesh_topology(mesh.vertices, mesh.unwrap, mesh.indices);
  UnionFind twins(static_cast<std::size_t>(mesh.charts));
  std::map<std::array<Corner, 3>, std::uint32_t> known;
  for (std::size_t t = 0; t < chart.size(); ++t) {
    if (mesh.triangle_chart[t] == no_chart) continue;
    const auto [entry, is_new] = known.try_emplace(corners_of(mesh, topology, t), chart[t]);
    if (!is_new) twins.join(entry->second, chart[t]);
  }
  return twins;
}

// Returns the cells of each chart, with those of its twins at the first of them; each once.
std::vector<Cells> cells_of_charts(const SkinMesh& mesh, std::span<const std::uint32_t> chart,
                                   UnionFind& twins) {
  std::vector<Cells> cells(static_cast<std::size_t>(mesh.charts));
  for (std::size_t t = 0; t < chart.size(); ++t) {
    if (mesh.triangle_chart[t] == no_chart) continue;
    Cells& of_chart = cells[twins.find(chart[t])];
    for_each_texel(triangle_uv(mesh, t), side,
                   [&](int x, int y) { of_chart.push_back(static_cast<std::uint32_t>(y * side + x)); });
  }

  for (Cells& of_chart : cells) {
    std::ranges::sort(of_chart);
    of_chart.erase(std::unique(of_chart.begin(), of_chart.end()), of_chart.end());
  }
  return cells;
}

// A layer of the map, and which of its cells are taken.
class Layer {
 public:
  bool has_room_for(const Cells& cells) const {
    const auto shared =
        std::count_if(cells.begin(), cells.end(), [&](std::uint32_t cell) { return taken_[cell]; });
    return static_cast<double>(shared) <= shared_at_borders * static_cast<double>(cells.size());
  }
  void take(const Cells& cells) {
    for (const std::uint32_t cell : cells) taken_[cell] = true;
  }

 private:
  std::vector<bool> taken_ = std::vector<bool>(std::size_t{side} * side);
};

// Returns the layer of each chart, which large ones choose first; none if they would be too many.
std::vector<std::size_t> layers_of(const std::vector<Cells>& charts) {
  std::vector<std::size_t> order(charts.size()), layer(charts.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::ranges::stable_sort(order, std::greater{}, [&](std::size_t c) { return charts[c].size(); });

  std::vector<Layer> layers(1);
  for (const std::size_t chart : order) {
    const auto has_room = [&](const Layer& l) { return l.has_room_for(charts[chart]); };
    auto found = std::ranges::find_if(layers, has_room);
    if (found == layers.end()) {
      if (layers.size() == most_layers) return {};
      found = layers.emplace(layers.end());
    }
    found->take(charts[chart]);
    layer[chart] = static_cast<std::size_t>(found - layers.begin());
  }
  return layer;
}

}  // namespace

void lay_charts_apart(SkinMesh& mesh, std::span<const std::uint32_t> chart) {
  if (mesh.charts < 2 || uv_area_sum(mesh) > most_layers) return;
  if (uv_overlap_fraction(mesh, side) <= few_overlap) return;

  UnionFind twins = twins_of(mesh, chart);
  const std::vector<std::size_t> layer_of = layers_of(cells_of_charts(mesh, chart, twins));
  if (layer_of.empty()) return;
  const std::size_t layers = std::ranges::max(layer_of) + 1;
  if (layers == 1) return;

  // Layers lie in a square of cells, with a margin around each for gutters.
  const auto columns = static_cast<std::size_t>(std::ceil(std::sqrt(static_cast<double>(layers))));
  const double width = 1 / static_cast<double>(columns);
  std::vector<bool> moved(mesh.vertices.size());
  for (std::size_t i = 0; i < mesh.indices.size(); ++i) {
    const std::uint32_t vertex = mesh.indices[i];
    if (mesh.triangle_chart[i / 3] == no_chart || moved[vertex]) continue;
    moved[vertex] = true;
    const std::size_t layer = layer_of[twins.find(chart[i / 3])];
    const glm::dvec2 cell(static_cast<double>(layer % columns), static_cast<double>(layer / columns));
    glm::vec2& at = mesh.unwrap[vertex];
    at = glm::vec2(width * (cell + fit_margin + (1 - 2 * fit_margin) * glm::dvec2(at)));
  }
  mesh.unwrap_scale *= width * (1 - 2 * fit_margin);
  mesh.layers = static_cast<int>(layers);
}

}  // namespace dermis::scene
