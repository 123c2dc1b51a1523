// SPDX-License-Identifier: MIT
#include "render/passes/asset/gutter_list.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdlib>
#include <iterator>
#include <set>

#include "base/core/parallel.h"
#include "head/scene/surface/coverage.h"
#include "render/shared/tiles_io.h"

namespace dermis::passes {
namespace {

constexpr int max_ring = 128;
constexpr int most_failures = 4096;

struct ChartMap {
  int side;
  std::vector<std::uint16_t> chart;
  bool has(int x, int y, std::uint16_t wanted) const {
    return x >= 0 && y >= 0 && x < side && y < side &&
           chart[static_cast<std::size_t>(y) * static_cast<std::size_t>(side) +
                 static_cast<std::size_t>(x)] == wanted;
  }
};

ChartMap rasterise(const scene::SkinMesh& mesh, int side) {
  ChartMap map{
      side, std::vector<std::uint16_t>(static_cast<std::size_t>(side) * static_cast<std::size_t>(side), 0)};
  for (std::size_t t = 0; t < mesh.triangle_chart.size(); ++t)
    scene::for_each_texel(scene::triangle_uv(mesh, t), side, [&](int x, int y) {
      map.chart[static_cast<std::size_t>(y) * static_cast<std::size_t>(side) + static_cast<std::size_t>(x)] =
          mesh.triangle_chart[t];
    });
  return map;
}

// Returns the nearest texel to (x, y) for which `wanted` is true; (x, y) if there is none. Searches square
// rings outwards; a ring at distance r holds nothing nearer than r.
template <class Wanted>
glm::ivec2 nearest(int x, int y, const Wanted& wanted) {
  glm::ivec2 best(x, y);
  int best2 = max_ring * max_ring;
  for (int r = 1; r < max_ring && r * r < best2; ++r)
    for (int d = -r; d <= r; ++d)
      for (const glm::ivec2 offset :
           {glm::ivec2(d, -r), glm::ivec2(d, r), glm::ivec2(-r, d), glm::ivec2(r, d)}) {
        const int distance2 = offset.x * offset.x + offset.y * offset.y;
        if (distance2 < best2 && wanted(x + offset.x, y + offset.y))
          best2 = distance2, best = glm::ivec2(x, y) + offset;
      }
  return best;
}

// Returns the nearest covered texel within two; the texel itself if there is none.
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

// Finds texels that build_gutters left empty although a pixel may read them.
class Leftovers {
 public:
  Leftovers(std::vector<scene::GutterTexel>& gutters, const ChartMap& covered)
      : gutters_(gutters), covered_(covered), listed_(covered.chart.size()) {
    for (const scene::GutterTexel& g : gutters) listed_[index(g.x, g.y)] = true;
  }

  void fill_corners() {
    for (int y = 0; y < covered_.side; ++y)
      for (int x = 0; x < covered_.side; ++x)
        if (empty(x, y)) add(x, y, nearest_covered(covered_, x, y));
  }

  // Triangles narrower than a texel may reach far beyond covered texels: reads along their edges find the
  // chart's nearest light.
  void fill_slivers(const scene::SkinMesh& mesh) {
    for (std::size_t t = 0; t < mesh.triangle_chart.size(); ++t) {
      if (mesh.triangle_chart[t] == scene::no_chart) continue;
      const std::array<glm::vec2, 3> uv = scene::triangle_uv(mesh, t);
      for (std::size_t i = 0; i < 3; ++i) fill_along(uv[i], uv[(i + 1) % 3], mesh.triangle_chart[t]);
    }
  }

 private:
  std::size_t index(int x, int y) const {
    return static_cast<std::size_t>(y) * static_cast<std::size_t>(covered_.side) +
           static_cast<std::size_t>(x);
  }
  bool inside(int x, int y) const { return x >= 0 && y >= 0 && x < covered_.side && y < covered_.side; }
  bool empty(int x, int y) const { return inside(x, y) && covered_.has(x, y, 0) && !listed_[index(x, y)]; }
  void add(int x, int y, const glm::ivec2& source) {
    if (source == glm::ivec2(x, y)) return;
    gutters_.push_back({.x = static_cast<std::uint16_t>(x),
                        .y = static_cast<std::uint16_t>(y),
                        .chart = 0,
                        .source_x = static_cast<float>(source.x) + 0.5f,
                        .source_y = static_cast<float>(source.y) + 0.5f});
  }
  void fill_along(const glm::vec2& from, const glm::vec2& to, std::uint16_t chart) {
    const float side = static_cast<float>(covered_.side);
    const float steps = std::ceil(2 * side * glm::distance(from, to));
    for (float k = 0; k <= steps; ++k) {
      const glm::vec2 corner = glm::floor(side * glm::mix(from, to, k / std::max(steps, 1.0f)) - 0.5f);
      for (int i = 0; i < 4; ++i) {
        const int x = static_cast<int>(corner.x) + (i & 1), y = static_cast<int>(corner.y) + (i >> 1);
        if (!empty(x, y) || failures_ > most_failures) continue;
        glm::ivec2 source = nearest(x, y, [&](int sx, int sy) { return covered_.has(sx, sy, chart); });
        if (source == glm::ivec2(x, y))
          source = nearest(x, y, [&](int sx, int sy) { return inside(sx, sy) && !covered_.has(sx, sy, 0); });
        if (source == glm::ivec2(x, y)) ++failures_;
        listed_[index(x, y)] = true;  // found or not: never searched again
        add(x, y, source);
      }
    }
  }

  std::vector<scene::GutterTexel>& gutters_;
  const ChartMap& covered_;
  std::vector<bool> listed_;
  int failures_ = 0;  // failed searches: an unwrap of lines across an empty map would take hours
};

}  // namespace

GutterList gutter_list(const scene::SkinMesh& mesh, int side, int width_texels) {
  const ChartMap covered = rasterise(mesh, side);
  GutterList list{.texels = scene::build_gutters(mesh, side, width_texels), .own = {}};
  Leftovers leftovers(list.texels, covered);
  leftovers.fill_corners();
  leftovers.fill_slivers(mesh);
  list.own.resize(list.texels.size());
  constexpr std::size_t block = 4096;
  parallel_for((list.texels.size() + block - 1) / block, [&](std::size_t b) {
    for (std::size_t i = b * block; i < std::min(list.texels.size(), (b + 1) * block); ++i) {
      const scene::GutterTexel& g = list.texels[i];
      list.own[i] = g.chart != 0 ? nearest(g.x, g.y, [&](int x, int y) { return covered.has(x, y, g.chart); })
                                 : glm::ivec2(g.x, g.y);
    }
  });
  return list;
}

std::vector<io::GutterIo> packed(const GutterList& list) {
  std::vector<io::GutterIo> all;
  for (std::size_t i = 0; i < list.texels.size(); ++i) {
    const scene::GutterTexel& texel = list.texels[i];
    all.push_back({.texel = texel.x | static_cast<std::uint32_t>(texel.y) << 16,
                   .own = list.own[i].x | list.own[i].y << 16,
                   .source = {texel.source_x, texel.source_y},
                   .chart = texel.chart});
  }
  return all;
}

std::vector<std::uint32_t> tile_links(const std::vector<io::GutterIo>& gutters, std::uint32_t side) {
  const glm::uvec2 across = io::tiles_across(side);
  const auto tile_at = [&](std::uint32_t x, std::uint32_t y) {
    return y / TILE_SIDE * across.x + x / TILE_SIDE;
  };
  const auto tile_of = [&](std::uint32_t packed) { return tile_at(packed & 0xFFFFu, packed >> 16); };

  // A link is the tile that it brings in, the seen tile, and the one that must not be seen.
  std::set<std::array<std::uint32_t, 3>> links;
  for (const io::GutterIo& g : gutters) {
    const std::uint32_t tile = tile_of(g.texel), own = tile_of(g.own),
                        source = tile_at(static_cast<std::uint32_t>(g.source.x),
                                         static_cast<std::uint32_t>(g.source.y));
    if (source != tile) links.insert({source, tile | TILE_LINK_LIGHTS, g.own == g.texel ? NO_TILE : own});
    if (g.chart == 0) continue;
    for (const std::uint32_t seen : {source, own})
      if (seen != tile) links.insert({tile, seen, NO_TILE});
  }

  std::vector<std::uint32_t> all;
  auto link = links.begin();
  for (std::uint32_t tile = 0; tile <= across.x * across.y; ++tile) {
    while (link != links.end() && (*link)[0] < tile) ++link;
    all.push_back(static_cast<std::uint32_t>(std::distance(links.begin(), link)));
  }
  for (const auto& [tile, seen, unless] : links) all.insert(all.end(), {seen, unless});
  return all;
}

}  // namespace dermis::passes
