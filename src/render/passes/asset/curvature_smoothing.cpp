// SPDX-License-Identifier: MIT
#include "render/passes/asset/curvature_smoothing.h"

#include <algorithm>
#include <cmath>

namespace dermis::passes {

int curvature_smoothing(const scene::SkinMesh& mesh, double mm_per_unit) {
  constexpr double sigma_mm = 1.5;
  double squares = 0;
  for (std::size_t i = 0; i < mesh.indices.size(); ++i) {
    const std::size_t next = i % 3 == 2 ? i - 2 : i + 1;
    const glm::dvec3 edge_mm = (glm::dvec3(mesh.vertices[mesh.indices[next]].position_m) -
                                glm::dvec3(mesh.vertices[mesh.indices[i]].position_m)) *
                               mm_per_unit;
    squares += glm::dot(edge_mm, edge_mm);
  }
  if (!(squares > 0)) return 2;
  const double times = 4 * sigma_mm * sigma_mm * static_cast<double>(mesh.indices.size()) / squares;
  return static_cast<int>(std::clamp(std::round(times), 2.0, 64.0));
}

}  // namespace dermis::passes
