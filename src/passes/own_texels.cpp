// SPDX-License-Identifier: MIT
#include "passes/own_texels.h"

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
    return x >= 0 && y >= 0 && x < side && y < side && chart[static_cast<std::size_t>(y) * static_cast<std::size_t>(side) + static_cast<std::size_t>(x)] == wanted;
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

}  // namespace

std::vector<glm::uvec2> own_texels(const scene::SkinMesh& mesh, std::span<const scene::GutterTexel> gutters, int map_size) {
  const ChartMap map = rasterise(mesh, map_size);
  std::vector<glm::uvec2> own(gutters.size());
  constexpr std::size_t block = 4096;
  parallel_for((gutters.size() + block - 1) / block, [&](std::size_t b) {
    for (std::size_t i = b * block; i < std::min(gutters.size(), (b + 1) * block); ++i)
      own[i] = gutters[i].chart != 0 ? nearest(map, gutters[i]) : glm::uvec2(gutters[i].x, gutters[i].y);
  });
  return own;
}

}  // namespace dermis::passes
