// SPDX-License-Identifier: MIT
#include "render/passes/asset/charts_first.h"

#include <algorithm>
#include <numeric>

namespace dermis::passes {

scene::SkinMesh charts_first(const scene::SkinMesh& skin) {
  std::vector<std::size_t> order(skin.triangle_chart.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::stable_partition(order.begin(), order.end(),
                        [&](std::size_t t) { return skin.triangle_chart[t] != scene::no_chart; });

  scene::SkinMesh sorted = skin;
  for (std::size_t i = 0; i < order.size(); ++i) {
    sorted.triangle_chart[i] = skin.triangle_chart[order[i]];
    sorted.triangle_material[i] = skin.triangle_material[order[i]];
    for (std::size_t k = 0; k < 3; ++k) sorted.indices[3 * i + k] = skin.indices[3 * order[i] + k];
  }
  return sorted;
}

}  // namespace dermis::passes
