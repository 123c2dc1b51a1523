// SPDX-License-Identifier: MIT
// Based on: [Dan80] Danielsson: Euclidean Distance Mapping. Computer Graphics and Image Processing 14, 1980
// (sweeps that pass on the nearest feature). Departure: features are segments with exact distances, and
// sweeps stay in the empty part of the map. This suffices: the straight line from an empty texel to its
// nearest border crosses empty texels only, or it would meet a nearer border.
#include "head/scene/surface/gutter_map.h"

#include <algorithm>
#include <cmath>

#include "base/core/assert.h"
#include "head/scene/surface/coverage.h"

namespace dermis::scene {
namespace {

glm::dvec2 texel_centre(int x, int y) { return {x + 0.5, y + 0.5}; }

glm::dvec2 offset_from(const BorderEdge& edge, const glm::dvec2& p) {
  return p - (edge.start + nearest_along(edge, p) * edge.vector);
}

}  // namespace

std::vector<BorderEdge> border_edges(const SkinMesh& mesh, const Topology& topology, int side) {
  std::vector<BorderEdge> borders;
  for (std::uint32_t half = 0; half < mesh.indices.size(); ++half) {
    if (topology.continuous[half]) continue;
    const std::array<glm::vec2, 3> uv = triangle_uv(mesh, half / 3);
    const double area2 = uv_area2(uv[0], uv[1], uv[2]);
    if (area2 == 0) continue;
    const glm::dvec2 start(uv[half % 3]), vector = glm::dvec2(uv[(half + 1) % 3]) - start;
    const glm::dvec2 outwards = glm::normalize(glm::dvec2(vector.y, -vector.x)) * (area2 > 0 ? 1.0 : -1.0);
    borders.push_back({half, topology.mate[half] == no_edge, start * static_cast<double>(side),
                       vector * static_cast<double>(side), outwards});
  }
  return borders;
}

double nearest_along(const BorderEdge& edge, const glm::dvec2& p) {
  return std::clamp(glm::dot(p - edge.start, edge.vector) / glm::dot(edge.vector, edge.vector), 0.0, 1.0);
}

GutterMap::GutterMap(const SkinMesh& mesh, const std::vector<BorderEdge>& borders, int side,
                     double reach_texels)
    : borders_(borders), side_(side), reach2_(static_cast<float>(reach_texels * reach_texels)) {
  DERMIS_ASSERT_LT(0, side);
  DERMIS_ASSERT_LE(side, 16384);

  const std::size_t texels = index(0, side);
  chart_.assign(texels, 0);
  for (std::size_t t = 0; t < mesh.indices.size() / 3; ++t)
    for_each_texel(triangle_uv(mesh, t), side,
                   [&](int x, int y) { chart_[index(x, y)] = mesh.triangle_chart[t]; });

  edge_.assign(texels, none);
  distance2_.assign(texels, 0);
  for (std::uint32_t e = 0; e < borders.size(); ++e) seed(e);

  for (std::size_t i = 0; i < texels; ++i) {
    // Counts texels whose centres lie within 1/256 texel of a border as uncovered; covered ones keep no edge.
    const bool doubtful = edge_[i] != none && distance2_[i] <= 1.0f / (256 * 256);
    if (doubtful) chart_[i] = 0;
    if (chart_[i] != 0) edge_[i] = none;
  }

  for (const bool downwards : {true, false, true, false}) sweep(downwards);
}

/// Keeps the nearer edge; of two equally near ones (they share an end) the one whose normal is closer to the
/// direction of the texel.
void GutterMap::offer(int x, int y, std::uint32_t edge) {
  const std::size_t i = index(x, y);
  if (edge_[i] == edge) return;
  const glm::dvec2 p = texel_centre(x, y), d = offset_from(borders_[edge], p);
  const auto distance2 = static_cast<float>(glm::dot(d, d));
  if (edge_[i] != none) {
    const float tie = 1e-5f * distance2_[i] + 1e-10f;
    if (distance2 > distance2_[i] + tie) return;
    if (distance2 >= distance2_[i] - tie) {
      const double squarely = glm::dot(d, borders_[edge].outwards),
                   before = glm::dot(d, borders_[edge_[i]].outwards);
      if (squarely < before || (squarely == before && edge > edge_[i])) return;
    }
  }
  edge_[i] = edge;
  distance2_[i] = distance2;
}

void GutterMap::offer_from(int x, int y, int from_x, int from_y) {
  if (!inside(from_x, from_y)) return;
  const std::size_t from = index(from_x, from_y);
  if (edge_[from] != none && distance2_[from] <= reach2_) offer(x, y, edge_[from]);
}

/// Offers the edge to all texels within about 1.5 texels, where sweeps start.
void GutterMap::seed(std::uint32_t edge) {
  constexpr double band = 1.5;
  const BorderEdge& b = borders_[edge];
  const glm::dvec2 end = b.start + b.vector;

  const auto first_texel = [](double low) { return static_cast<int>(std::ceil(low - 0.5)); };
  const int y0 = std::max(0, first_texel(std::min(b.start.y, end.y) - band));
  const int y1 = std::min(side_ - 1, static_cast<int>(std::floor(std::max(b.start.y, end.y) + band - 0.5)));

  for (int y = y0; y <= y1; ++y) {
    double s0 = 0, s1 = 1;  // part of the edge near this row
    if (std::abs(b.vector.y) > 1e-9) {
      const double u = (y + 0.5 - band - b.start.y) / b.vector.y,
                   v = (y + 0.5 + band - b.start.y) / b.vector.y;
      s0 = std::clamp(std::min(u, v), 0.0, 1.0);
      s1 = std::clamp(std::max(u, v), 0.0, 1.0);
    }

    const double xa = b.start.x + s0 * b.vector.x, xb = b.start.x + s1 * b.vector.x;
    const int x0 = std::max(0, first_texel(std::min(xa, xb) - band));
    const int x1 = std::min(side_ - 1, static_cast<int>(std::floor(std::max(xa, xb) + band - 0.5)));
    for (int x = x0; x <= x1; ++x) offer(x, y, edge);
  }
}

void GutterMap::sweep(bool downwards) {
  for (int row = 0; row < side_; ++row) {
    const int y = downwards ? row : side_ - 1 - row, from_y = downwards ? y - 1 : y + 1;
    for (int x = 0; x < side_; ++x) {
      if (chart_[index(x, y)] != 0) continue;
      for (const int dx : {-1, 0, 1}) offer_from(x, y, x + dx, from_y);
      offer_from(x, y, x - 1, y);
    }
    for (int x = side_ - 1; x >= 0; --x)
      if (chart_[index(x, y)] == 0) offer_from(x, y, x + 1, y);
  }
}

std::optional<glm::dvec2> GutterMap::nearest_centre(const glm::dvec2& p, std::uint16_t chart,
                                                    int reach) const {
  const int cx = static_cast<int>(std::floor(p.x)), cy = static_cast<int>(std::floor(p.y));
  std::optional<glm::dvec2> best;
  for (int y = cy - reach; y <= cy + reach; ++y) {
    for (int x = cx - reach; x <= cx + reach; ++x) {
      const std::uint16_t found = this->chart(x, y);
      if (found == 0 || (chart != 0 && found != chart)) continue;
      const glm::dvec2 c = texel_centre(x, y);
      if (!best || glm::distance(c, p) < glm::distance(*best, p)) best = c;
    }
  }
  return best;
}

std::optional<glm::dvec2> GutterMap::safe_read(const glm::dvec2& p, std::uint16_t chart) const {
  const int x = static_cast<int>(std::floor(p.x - 0.5)), y = static_cast<int>(std::floor(p.y - 0.5));
  const auto good = [&](int dx, int dy) { return this->chart(x + dx, y + dy) == chart; };
  const bool g00 = good(0, 0), g10 = good(1, 0), g01 = good(0, 1), g11 = good(1, 1);
  if (g00 && g10 && g01 && g11) return p;
  // If two neighbours are good, the segment between their centres is safe, since the other two have weight 0
  // there.
  std::optional<glm::dvec2> best;
  const auto consider = [&](bool both, const glm::dvec2& q) {
    if (both && (!best || glm::distance(q, p) < glm::distance(*best, p))) best = q;
  };
  consider(g00 && g10, {p.x, y + 0.5});
  consider(g01 && g11, {p.x, y + 1.5});
  consider(g00 && g01, {x + 0.5, p.y});
  consider(g10 && g11, {x + 1.5, p.y});
  return best ? best : nearest_centre(p, chart, 6);
}

}  // namespace dermis::scene
