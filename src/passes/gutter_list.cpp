// SPDX-License-Identifier: MIT
#include "passes/gutter_list.h"

#include <algorithm>
#include <cmath>
#include <cstdlib>

#include "core/parallel.h"
#include "scene/coverage.h"

namespace dermis::passes {
namespace {

constexpr int max_ring = 128;

struct ChartMap {
  int side;
  std::vector<std::uint16_t> chart;
  bool has(int x, int y, std::uint16_t wanted) const {
    return x >= 0 && y >= 0 && x < side && y < side &&
           chart[static_cast<std::size_t>(y) * static_cast<std::size_t>(side) + static_cast<std::size_t>(x)] == wanted;
  }
};

ChartMap rasterise(const scene::SkinMesh& mesh, int side) {
  ChartMap map{side, std::vector<std::uint16_t>(static_cast<std::size_t>(side) * static_cast<std::size_t>(side), 0)};
  for (std::size_t t = 0; t < mesh.triangle_chart.size(); ++t)
    scene::for_each_texel(scene::triangle_uv(mesh, t), side, [&](int x, int y) {
      map.chart[static_cast<std::size_t>(y) * static_cast<std::size_t>(side) + static_cast<std::size_t>(x)] = mesh.triangle_chart[t];
    });
  return map;
}

// Square rings outwards; a ring at distance r cannot hold anything nearer than r.
glm::uvec2 nearest(const ChartMap& map, const scene::GutterTexel& g) {
  glm::ivec2 best(g.x, g.y);
  int best2 = max_ring * max_ring;
  for (int r = 1; r < max_ring && r * r < best2; ++r)
    for (int d = -r; d <= r; ++d)
      for (const glm::ivec2 offset : {glm::ivec2(d, -r), glm::ivec2(d, r), glm::ivec2(-r, d), glm::ivec2(r, d)}) {
        const int distance2 = offset.x * offset.x + offset.y * offset.y;
        if (distance2 < best2 && map.has(g.x + offset.x, g.y + offset.y, g.chart)) best2 = distance2, best = glm::ivec2(g.x, g.y) + offset;
      }
  return glm::uvec2(best);
}

// The nearest covered texel within two; itself if there is none.
glm::ivec2 nearest_covered(const ChartMap& map, int x, int y) {
  glm::ivec2 best(x, y);
  int best2 = 9;
  for (int dy = -2; dy <= 2; ++dy)
    for (int dx = -2; dx <= 2; ++dx) {
      const int sx = x + dx, sy = y + dy, distance2 = dx * dx + dy * dy;
      if (distance2 < best2 && sx >= 0 && sy >= 0 && sx < map.side && sy < map.side && !map.has(sx, sy, 0))
        best2 = distance2, best = {sx, sy};
    }
  return best;
}

// Appends what build_gutters left empty beside the charts.
void fill_corners(std::vector<scene::GutterTexel>& gutters, const ChartMap& covered) {
  std::vector<bool> listed(covered.chart.size());
  const auto index = [&](int x, int y) {
    return static_cast<std::size_t>(y) * static_cast<std::size_t>(covered.side) + static_cast<std::size_t>(x);
  };
  for (const scene::GutterTexel& g : gutters) listed[index(g.x, g.y)] = true;
  for (int y = 0; y < covered.side; ++y)
    for (int x = 0; x < covered.side; ++x) {
      if (listed[index(x, y)] || covered.chart[index(x, y)] != 0) continue;
      const glm::ivec2 near = nearest_covered(covered, x, y);
      if (near == glm::ivec2(x, y)) continue;
      gutters.push_back({.x = static_cast<std::uint16_t>(x),
                         .y = static_cast<std::uint16_t>(y),
                         .chart = 0,
                         .source_x = static_cast<float>(near.x) + 0.5f,
                         .source_y = static_cast<float>(near.y) + 0.5f});
    }
}

}  // namespace

GutterList gutter_list(const scene::SkinMesh& mesh, int map_size, int width_texels) {
  const ChartMap covered = rasterise(mesh, map_size);
  GutterList list{.texels = scene::build_gutters(mesh, map_size, width_texels), .own = {}};
  fill_corners(list.texels, covered);
  list.own.resize(list.texels.size());
  constexpr std::size_t block = 4096;
  parallel_for((list.texels.size() + block - 1) / block, [&](std::size_t b) {
    for (std::size_t i = b * block; i < std::min(list.texels.size(), (b + 1) * block); ++i) {
      const scene::GutterTexel& g = list.texels[i];
      list.own[i] = g.chart != 0 ? nearest(covered, g) : glm::uvec2(g.x, g.y);
    }
  });
  return list;
}

}  // namespace dermis::passes
