// SPDX-License-Identifier: MIT
#include "render/passes/asset/first_corners.h"

namespace dermis::passes {

std::vector<std::uint32_t> first_corner_indices(std::span<const std::uint32_t> indices) {
  const auto triangles = static_cast<std::uint32_t>(indices.size() / 3);
  std::vector<std::uint32_t> out;
  out.reserve(indices.size());
  for (std::uint32_t t = 0; t < triangles; ++t)
    out.insert(out.end(), {t, triangles + indices[3 * t + 1], triangles + indices[3 * t + 2]});
  return out;
}

}  // namespace dermis::passes
