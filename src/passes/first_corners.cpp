// SPDX-License-Identifier: MIT
#include "passes/first_corners.h"

namespace dermis::passes {

std::vector<std::uint32_t> first_corner_indices(std::span<const std::uint32_t> indices,
                                                std::size_t vertices) {
  const auto triangles = static_cast<std::uint32_t>(indices.size() / 3);
  std::vector<std::uint32_t> latest(vertices);  // the index under which a vertex was drawn last
  for (std::size_t v = 0; v < vertices; ++v) latest[v] = triangles + static_cast<std::uint32_t>(v);

  std::vector<std::uint32_t> out(indices.size());
  for (std::uint32_t t = 0; t < triangles; ++t) {
    const std::span corners = indices.subspan(std::size_t{3} * t, 3);
    out[3 * t] = latest[corners[0]] = t;
    for (std::size_t k = 1; k < 3; ++k) out[3 * t + k] = latest[corners[k]];
  }
  return out;
}

}  // namespace dermis::passes
