// SPDX-License-Identifier: MIT
#include "head/scene/surface/gutters.h"

#include <optional>

#include "base/core/assert.h"
#include "base/core/parallel.h"
#include "base/core/warnings.h"
#include "head/scene/surface/coverage.h"
#include "head/scene/surface/gutter_map.h"
#include "head/scene/surface/walk.h"

namespace dermis::scene {
namespace {

constexpr double open_border_texels = 2;

struct Builder {
  const SkinMesh& mesh;
  const std::vector<BorderEdge>& borders;
  const GutterMap& map;
  const Walker& walker;
  int width_texels;

  /// Returns where the skin continues beyond the border, in texels, and on which chart.
  std::optional<GutterTexel> continued(const BorderEdge& edge, const glm::dvec2& p) const {
    const double along = nearest_along(edge, p), side = map.side();
    const std::optional<MeshPoint> end =
        walker.leave(edge.half, along, (p - edge.start - along * edge.vector) / side);
    if (!end || mesh.triangle_chart[end->triangle] == no_chart) return std::nullopt;
    glm::dvec2 uv(0);
    for (int k = 0; k < 3; ++k)
      uv += end->barycentric[k] *
            glm::dvec2(mesh.unwrap[mesh.indices[3 * end->triangle + static_cast<std::uint32_t>(k)]]);
    const std::optional<glm::dvec2> source = map.safe_read(uv * side, mesh.triangle_chart[end->triangle]);
    if (!source) return std::nullopt;
    GutterTexel texel;
    texel.chart = mesh.triangle_chart[edge.half / 3];
    texel.source_x = static_cast<float>(source->x);
    texel.source_y = static_cast<float>(source->y);
    return texel;
  }

  std::optional<GutterTexel> texel(int x, int y) const {
    if (map.chart(x, y) != 0 || map.edge(x, y) == GutterMap::none) return std::nullopt;
    const double distance = map.distance(x, y);
    if (distance > std::max<double>(width_texels, open_border_texels)) return std::nullopt;
    const BorderEdge& edge = borders[map.edge(x, y)];
    const glm::dvec2 p(x + 0.5, y + 0.5);
    std::optional<GutterTexel> made;
    if (!edge.open && distance <= width_texels) made = continued(edge, p);
    if (!made && distance <= open_border_texels) {
      const std::optional<glm::dvec2> centre = map.nearest_centre(p, 0, 4);
      if (centre) made = GutterTexel{0, 0, 0, static_cast<float>(centre->x), static_cast<float>(centre->y)};
    }
    if (made) {
      made->x = static_cast<std::uint16_t>(x);
      made->y = static_cast<std::uint16_t>(y);
    }
    return made;
  }
};

}  // namespace

std::vector<GutterTexel> build_gutters(const SkinMesh& mesh, int side, int width_texels) {
  DERMIS_ASSERT_LE(1, width_texels);
  if (uv_area_sum(mesh) > 64) {
    warn_of("skin: texture coordinates cover the map over 64 times; light does not flow across seams",
            mesh.name,
            fmt::format("skin '{}': its texture coordinates cover the map {:.0f} times; light does not flow "
                        "across its seams",
                        mesh.name, uv_area_sum(mesh)));
    return {};
  }
  const Topology topology = mesh_topology(mesh.vertices, mesh.unwrap, mesh.indices);
  const std::vector<BorderEdge> borders = border_edges(mesh, topology, side);
  const GutterMap map(mesh, borders, side, std::max<double>(width_texels, open_border_texels) + 2);
  const Walker walker(topology, mesh.vertices, mesh.unwrap, mesh.indices);
  const Builder builder{mesh, borders, map, walker, width_texels};

  std::vector<std::vector<GutterTexel>> rows(static_cast<std::size_t>(side));
  parallel_for(rows.size(), [&](std::size_t y) {
    for (int x = 0; x < side; ++x) {
      if (const std::optional<GutterTexel> texel = builder.texel(x, static_cast<int>(y)))
        rows[y].push_back(*texel);
    }
  });
  std::vector<GutterTexel> gutters;
  for (const std::vector<GutterTexel>& row : rows) gutters.insert(gutters.end(), row.begin(), row.end());
  return gutters;
}

}  // namespace dermis::scene
