// SPDX-License-Identifier: MIT
#include "head/scene/surface/weld.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <unordered_map>

namespace dermis::scene {
namespace {

using Cell = std::array<std::int64_t, 3>;

struct CellHash {
  std::size_t operator()(const Cell& cell) const {
    std::uint64_t h = 0x9e3779b97f4a7c15u;
    for (const std::int64_t c : cell) {
      h = (h ^ static_cast<std::uint64_t>(c)) * 0xff51afd7ed558ccdu;
      h ^= h >> 32;
    }
    return static_cast<std::size_t>(h);
  }
};

std::int64_t rounded(double value, double grid) {
  const double cells = value / grid;
  if (!std::isfinite(cells)) return 0;
  return static_cast<std::int64_t>(std::nearbyint(std::clamp(cells, -4e18, 4e18)));
}

}  // namespace

std::vector<std::uint32_t> weld_points(std::span<const glm::dvec3> points, double grid) {
  std::unordered_map<Cell, std::uint32_t, CellHash> known;
  known.reserve(points.size());
  std::vector<std::uint32_t> ids;
  ids.reserve(points.size());
  for (const glm::dvec3& p : points) {
    const Cell cell{rounded(p.x, grid), rounded(p.y, grid), rounded(p.z, grid)};
    ids.push_back(known.try_emplace(cell, static_cast<std::uint32_t>(known.size())).first->second);
  }
  return ids;
}

std::vector<std::uint32_t> weld_positions(std::span<const Vertex> vertices) {
  std::vector<glm::dvec3> points;
  points.reserve(vertices.size());
  glm::dvec3 low(0), high(0);
  for (const Vertex& v : vertices) {
    const glm::dvec3 p(v.position_m);
    low = points.empty() ? p : glm::min(low, p);
    high = points.empty() ? p : glm::max(high, p);
    points.push_back(p);
  }
  const glm::dvec3 extent = high - low;
  return weld_points(points, std::max(1e-6 * std::max({extent.x, extent.y, extent.z}), 1e-30));
}

std::vector<std::uint32_t> weld_uv(std::span<const glm::vec2> uv) {
  std::vector<glm::dvec3> points;
  points.reserve(uv.size());
  for (const glm::vec2& t : uv) points.emplace_back(t.x, t.y, 0.0);
  return weld_points(points, 1e-6);
}

}  // namespace dermis::scene
