// SPDX-License-Identifier: MIT
// The two maps behind the gutters: the chart that covers a texel, and the border edge nearest to an uncovered
// one.
#pragma once

#include <cstdint>
#include <glm/glm.hpp>
#include <optional>
#include <vector>

#include "head/scene/surface/topology.h"
#include "head/scene/surface/unwrap.h"

namespace dermis::scene {

/// An edge of a chart in texels.
struct BorderEdge {
  std::uint32_t half = 0;  ///< of SkinMesh::indices
  bool open = false;       ///< has no neighbour at the same place
  glm::dvec2 start{0}, vector{0};
  glm::dvec2 outwards{0};  ///< unit, away from the triangle
};

/// Returns the half edges across which the unwrap does not continue, of triangles with area on a map of
/// `side` x `side` texels.
std::vector<BorderEdge> border_edges(const SkinMesh& mesh, const Topology& topology, int side);

/// Returns where on the edge the point nearest to `p` lies: 0 start, 1 end.
double nearest_along(const BorderEdge& edge, const glm::dvec2& p);

class GutterMap {
 public:
  static constexpr std::uint32_t none = 0xffffffffu;

  /// Finds charts by coverage, without texels within 1/256 texel of a border; for all others the nearest
  /// edge, up to reach_texels.
  GutterMap(const SkinMesh& mesh, const std::vector<BorderEdge>& borders, int side, double reach_texels);

  int side() const { return side_; }
  /// Returns 0 for texels that are not surely covered, and for texels outside the map.
  std::uint16_t chart(int x, int y) const { return inside(x, y) ? chart_[index(x, y)] : std::uint16_t{0}; }
  /// Returns an index into `borders`, or none. Only for texels with chart 0.
  std::uint32_t edge(int x, int y) const { return edge_[index(x, y)]; }
  double distance(int x, int y) const { return std::sqrt(static_cast<double>(distance2_[index(x, y)])); }

  /// Returns the point nearest to `p` (texels, centres at .5) whose bilinear footprint lies only on texels of
  /// `chart`; nothing if none is within 6 texels.
  std::optional<glm::dvec2> safe_read(const glm::dvec2& p, std::uint16_t chart) const;
  /// Returns the centre of the covered texel nearest to `p`, of any chart if `chart` is 0; nothing if none is
  /// within `reach` texels.
  std::optional<glm::dvec2> nearest_centre(const glm::dvec2& p, std::uint16_t chart, int reach) const;

 private:
  bool inside(int x, int y) const { return x >= 0 && y >= 0 && x < side_ && y < side_; }
  std::size_t index(int x, int y) const {
    return static_cast<std::size_t>(y) * static_cast<std::size_t>(side_) + static_cast<std::size_t>(x);
  }
  void offer(int x, int y, std::uint32_t edge);
  void offer_from(int x, int y, int from_x, int from_y);
  void seed(std::uint32_t edge);
  void sweep(bool downwards);

  const std::vector<BorderEdge>& borders_;
  int side_;
  float reach2_;
  std::vector<std::uint16_t> chart_;
  std::vector<std::uint32_t> edge_;
  std::vector<float> distance2_;
};

}  // namespace dermis::scene
