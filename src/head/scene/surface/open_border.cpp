// SPDX-License-Identifier: MIT
#include "head/scene/surface/open_border.h"

#include <algorithm>
#include <functional>
#include <queue>
#include <utility>

#include "head/scene/surface/topology.h"

namespace dermis::scene {
namespace {

/// Ways along edges: those from place p (vertices at one place are one) are [first[p], first[p + 1]) of
/// `ways`.
struct Way {
  std::uint32_t to = 0;
  float length_mm = 0;
};
struct Ways {
  std::vector<std::uint32_t> first;
  std::vector<Way> ways;
};

Ways ways_of(const SkinMesh& mesh, std::span<const std::uint32_t> place, std::size_t places,
             double mm_per_unit) {
  Ways out;
  out.first.assign(places + 1, 0);
  for (const std::uint32_t vertex : mesh.indices) out.first[place[vertex] + 1] += 2;
  for (std::size_t p = 0; p < places; ++p) out.first[p + 1] += out.first[p];

  out.ways.resize(2 * mesh.indices.size());
  std::vector<std::uint32_t> next(out.first.begin(), out.first.end() - 1);
  for (std::uint32_t half = 0; half < mesh.indices.size(); ++half) {
    const std::uint32_t a = mesh.indices[half], b = mesh.indices[next_corner(half)];
    const auto length_mm = static_cast<float>(
        mm_per_unit * glm::length(glm::dvec3(mesh.vertices[a].position_m - mesh.vertices[b].position_m)));
    out.ways[next[place[a]]++] = {place[b], length_mm};
    out.ways[next[place[b]]++] = {place[a], length_mm};
  }
  return out;
}

/// Shortens distances, 0 at the border and most_mm elsewhere, to the lengths of the shortest ways (Dijkstra
/// 1959).
void shorten(std::vector<float>& distance_mm, const Ways& ways) {
  using Reached = std::pair<float, std::uint32_t>;
  std::priority_queue<Reached, std::vector<Reached>, std::greater<>> open;
  for (std::uint32_t p = 0; p < distance_mm.size(); ++p)
    if (distance_mm[p] == 0) open.emplace(0.0f, p);

  while (!open.empty()) {
    const auto [reached_mm, p] = open.top();
    open.pop();
    if (reached_mm > distance_mm[p]) continue;
    for (std::uint32_t i = ways.first[p]; i < ways.first[p + 1]; ++i) {
      const auto [to, length_mm] = ways.ways[i];
      if (reached_mm + length_mm >= distance_mm[to]) continue;
      distance_mm[to] = reached_mm + length_mm;
      open.emplace(distance_mm[to], to);
    }
  }
}

}  // namespace

std::vector<float> border_distances_mm(const SkinMesh& mesh, double mm_per_unit, float most_mm) {
  const Topology topology = mesh_topology(mesh.vertices, mesh.unwrap, mesh.indices);
  const std::vector<std::uint32_t>& place = topology.position_id;
  const std::size_t places = place.empty() ? 0 : *std::ranges::max_element(place) + std::size_t{1};

  std::vector<float> distance_mm(places, most_mm);
  for (std::uint32_t half = 0; half < mesh.indices.size(); ++half) {
    const std::uint32_t a = place[mesh.indices[half]], b = place[mesh.indices[next_corner(half)]];
    if (a != b && topology.mate[half] == no_edge) distance_mm[a] = distance_mm[b] = 0;
  }
  shorten(distance_mm, ways_of(mesh, place, places, mm_per_unit));

  std::vector<float> per_vertex;
  per_vertex.reserve(place.size());
  for (const std::uint32_t p : place) per_vertex.push_back(distance_mm[p]);
  return per_vertex;
}

}  // namespace dermis::scene
