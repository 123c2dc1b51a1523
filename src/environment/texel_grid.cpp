// SPDX-License-Identifier: MIT
#include "environment/texel_grid.h"

#include <algorithm>
#include <utility>

#include "head/scene/surface/coverage.h"

namespace dermis::environment {

TexelGrid rasterise(const scene::SkinMesh& mesh, int side) {
  TexelGrid grid{side,
                 std::vector<GridTexel>(static_cast<std::size_t>(side) * static_cast<std::size_t>(side))};
  for (std::size_t t = 0; t < mesh.triangle_chart.size(); ++t) {
    const auto uv = scene::triangle_uv(mesh, t);
    const glm::dvec2 a(uv[0]), b = glm::dvec2(uv[1]) - a, c = glm::dvec2(uv[2]) - a;
    const double area = b.x * c.y - b.y * c.x;
    if (area == 0) continue;
    scene::for_each_texel(uv, side, [&](int x, int y) {
      const glm::dvec2 p = glm::dvec2(x + 0.5, y + 0.5) / static_cast<double>(side) - a;
      const double u = std::clamp((p.x * c.y - p.y * c.x) / area, 0.0, 1.0),
                   v = std::clamp((b.x * p.y - b.y * p.x) / area, 0.0, 1.0 - u);
      grid.texels[grid.at(x, y)] = {static_cast<std::uint32_t>(t), static_cast<float>(u),
                                    static_cast<float>(v)};
    });
  }
  return grid;
}

TexelGrid dilated(const TexelGrid& grid) {
  // Sides before corners: the nearest neighbour of a ring.
  constexpr std::pair<int, int> steps[] = {{-1, 0},  {1, 0},  {0, -1}, {0, 1},
                                           {-1, -1}, {1, -1}, {-1, 1}, {1, 1}};
  TexelGrid out = grid;
  for (int ring = 0; ring < dilation; ++ring) {
    const TexelGrid before = out;
    for (int y = 0; y < grid.side; ++y)
      for (int x = 0; x < grid.side; ++x) {
        GridTexel& texel = out.texels[grid.at(x, y)];
        for (const auto& [dx, dy] : steps) {
          if (texel.covered()) break;
          const bool inside = x + dx >= 0 && y + dy >= 0 && x + dx < grid.side && y + dy < grid.side;
          if (inside) texel = before.texels[grid.at(x + dx, y + dy)];
        }
      }
  }
  return out;
}

}  // namespace dermis::environment
