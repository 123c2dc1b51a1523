// SPDX-License-Identifier: MIT
#include "head/scene/surface/topology.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <tuple>

#include "base/core/assert.h"
#include "head/scene/surface/union_find.h"
#include "head/scene/surface/weld.h"

namespace dermis::scene {
namespace {

/// A half edge keyed by the places and coordinates of its ends, lower place first.
struct EdgeEntry {
  std::uint32_t place_a, place_b, uv_a, uv_b, half;
  auto place() const { return std::tie(place_a, place_b); }
  auto key() const { return std::tie(place_a, place_b, uv_a, uv_b, half); }
  bool same_uv(const EdgeEntry& o) const { return uv_a == o.uv_a && uv_b == o.uv_b; }
};

std::vector<EdgeEntry> sorted_edges(const Topology& topology, std::span<const std::uint32_t> indices) {
  std::vector<EdgeEntry> edges;
  edges.reserve(indices.size());
  for (std::uint32_t half = 0; half < indices.size(); ++half) {
    std::uint32_t a = indices[half], b = indices[next_corner(half)];
    if (topology.position_id[a] == topology.position_id[b]) continue;
    if (topology.position_id[a] > topology.position_id[b]) std::swap(a, b);
    edges.push_back(
        {topology.position_id[a], topology.position_id[b], topology.uv_id[a], topology.uv_id[b], half});
  }
  std::sort(edges.begin(), edges.end(),
            [](const EdgeEntry& x, const EdgeEntry& y) { return x.key() < y.key(); });
  return edges;
}

/// Pairs the half edges of one place: first neighbours in the order that share coordinates, then the rest two
/// by two.
void pair_edges(std::span<const EdgeEntry> edges, std::vector<std::uint32_t>& mate) {
  const auto join = [&](std::uint32_t a, std::uint32_t b) { mate[a] = b, mate[b] = a; };
  std::uint32_t left = no_edge;
  for (std::size_t i = 0; i < edges.size(); ++i) {
    if (i + 1 < edges.size() && edges[i].same_uv(edges[i + 1])) {
      join(edges[i].half, edges[i + 1].half);
      ++i;
    } else if (left == no_edge) {
      left = edges[i].half;
    } else {
      join(left, edges[i].half);
      left = no_edge;
    }
  }
}

}  // namespace

double uv_area2(const glm::vec2& a, const glm::vec2& b, const glm::vec2& c) {
  const glm::dvec2 p(a), e1 = glm::dvec2(b) - p, e2 = glm::dvec2(c) - p;
  const double area2 = e1.x * e2.y - e1.y * e2.x;
  const double magnitude = std::max({glm::length(p), glm::length(glm::dvec2(b)), glm::length(glm::dvec2(c))});
  const double noise =
      std::numeric_limits<float>::epsilon() * magnitude * std::max(glm::length(e1), glm::length(e2));
  return std::abs(area2) > noise ? area2 : 0.0;
}

Topology mesh_topology(std::span<const Vertex> vertices, std::span<const glm::vec2> uv,
                       std::span<const std::uint32_t> indices) {
  DERMIS_ASSERT_EQ(vertices.size(), uv.size());
  DERMIS_ASSERT_EQ(indices.size() % 3, std::size_t{0});
  DERMIS_ASSERT_LT(indices.size(), std::size_t{no_edge});
  Topology topology{weld_positions(vertices), weld_uv(uv), {}, {}};
  topology.mate.assign(indices.size(), no_edge);
  const std::vector<EdgeEntry> edges = sorted_edges(topology, indices);
  for (std::size_t begin = 0; begin < edges.size();) {
    std::size_t end = begin + 1;
    while (end < edges.size() && edges[end].place() == edges[begin].place()) ++end;
    pair_edges(std::span(edges).subspan(begin, end - begin), topology.mate);
    begin = end;
  }

  const auto area2 = [&](std::uint32_t half) {
    const std::uint32_t t = half / 3 * 3;
    return uv_area2(uv[indices[t]], uv[indices[t + 1]], uv[indices[t + 2]]);
  };
  topology.continuous.assign(indices.size(), false);
  for (std::uint32_t half = 0; half < indices.size(); ++half) {
    const std::uint32_t other = topology.mate[half];
    if (other == no_edge) continue;
    std::uint32_t c = indices[other], d = indices[next_corner(other)];
    const std::uint32_t a = indices[half], b = indices[next_corner(half)];
    // With equal winding the mate runs the other way; then equal signs mean that the triangles lie on
    // opposite sides.
    const bool reversed = topology.position_id[a] == topology.position_id[d];
    if (reversed) std::swap(c, d);
    if (topology.uv_id[a] != topology.uv_id[c] || topology.uv_id[b] != topology.uv_id[d]) continue;
    topology.continuous[half] = area2(half) * area2(other) * (reversed ? 1.0 : -1.0) > 0;
  }
  return topology;
}

std::vector<std::uint32_t> find_charts(const Topology& topology, std::span<const glm::vec2> uv,
                                       std::span<const std::uint32_t> indices) {
  const auto triangles = static_cast<std::uint32_t>(indices.size() / 3);
  UnionFind sets(triangles);
  for (std::uint32_t half = 0; half < indices.size(); ++half)
    if (topology.continuous[half]) sets.join(half / 3, topology.mate[half] / 3);

  std::vector<std::uint32_t> host(triangles);  // triangle whose chart each one takes
  const auto flat = [&](std::uint32_t t) {
    return uv_area2(uv[indices[3 * t]], uv[indices[3 * t + 1]], uv[indices[3 * t + 2]]) == 0;
  };
  const auto uv_of = [&](std::uint32_t half) { return topology.uv_id[indices[half]]; };
  for (std::uint32_t t = 0; t < triangles; ++t) {
    host[t] = t;
    if (!flat(t)) continue;
    for (std::uint32_t half = 3 * t; half < 3 * t + 3 && host[t] == t; ++half) {
      const std::uint32_t other = topology.mate[half];
      if (other == no_edge || flat(other / 3)) continue;
      const std::uint32_t a = uv_of(half), b = uv_of(next_corner(half)), c = uv_of(other),
                          d = uv_of(next_corner(other));
      if ((a == c && b == d) || (a == d && b == c)) host[t] = other / 3;
    }
  }
  std::vector<std::uint32_t> number(triangles, no_edge), chart(triangles);
  std::uint32_t charts = 0;
  for (std::uint32_t t = 0; t < triangles; ++t) {
    std::uint32_t& n = number[sets.find(host[t])];
    if (n == no_edge) n = charts++;
    chart[t] = n;
  }
  return chart;
}

}  // namespace dermis::scene
