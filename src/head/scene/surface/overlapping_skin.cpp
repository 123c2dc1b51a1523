// SPDX-License-Identifier: MIT
#include "head/scene/surface/overlapping_skin.h"

#include <algorithm>
#include <array>
#include <map>
#include <set>
#include <vector>

#include "head/scene/import/complete.h"
#include "head/scene/surface/coverage.h"
#include "head/scene/surface/unwrap.h"

namespace dermis::scene {
namespace {

constexpr int side = 128;                   // cells of a unit square
constexpr std::size_t most_tiles = 100;     // 10 x 10 of UDIM; what lies in further ones is not looked at
constexpr double shared_at_borders = 0.02;  // of the cells of a material: charts may touch

using Tile = std::pair<int, int>;

// Texture coordinates that a node's skin covers: per cell the material that came first.
class Cells {
 public:
  void add(const Primitive& primitive) {
    for (std::size_t i = 0; i < primitive.indices.size(); i += 3) {
      std::array<glm::vec2, 3> uv;
      for (std::size_t k = 0; k < 3; ++k) uv[k] = primitive.vertices[primitive.indices[i + k]].uv0;
      add(uv, primitive.material);
    }
  }

  std::set<int> overlapping() const {
    std::set<int> found;
    for (const auto& [pair, shared] : shared_) {
      const int cells = std::min(cells_.at(pair.first), cells_.at(pair.second));
      if (shared > shared_at_borders * cells) found.insert({pair.first, pair.second});
    }
    return found;
  }

 private:
  void add(std::array<glm::vec2, 3> uv, int material) {
    const glm::vec2 low = glm::floor(glm::min(uv[0], glm::min(uv[1], uv[2])));
    const Tile tile(low.x, low.y);
    if (!first_.contains(tile) && first_.size() >= most_tiles) return;
    std::vector<int>& first = first_.try_emplace(tile, side * side, nothing).first->second;

    for (glm::vec2& corner : uv) corner -= low;
    for_each_texel(uv, side, [&](int x, int y) {
      int& owner = first[static_cast<std::size_t>(y * side + x)];
      if (owner == nothing) owner = material;
      if (owner != material) ++shared_[std::minmax(owner, material)];
      ++cells_[material];
    });
  }

  static constexpr int nothing = -1;
  std::map<Tile, std::vector<int>> first_;
  std::map<std::pair<int, int>, int> shared_;
  std::map<int, int> cells_;
};

bool is_skin(const AssetData& scene, const Primitive& primitive) {
  return scene.materials[static_cast<std::size_t>(primitive.material)].skin && primitive.has_uv;
}

}  // namespace

void part_overlapping_skin(const std::string& file, AssetData& scene) {
  std::map<int, std::vector<Primitive*>> of_node;
  for (Primitive& primitive : scene.primitives)
    if (is_skin(scene, primitive)) of_node[primitive.node].push_back(&primitive);

  std::set<SkinMeshKey> light_maps;
  for (auto& of_one : of_node) {
    const std::vector<Primitive*>& primitives = of_one.second;
    const auto is_of_first = [&](const Primitive* p) { return p->material == primitives[0]->material; };
    if (!std::all_of(primitives.begin(), primitives.end(), is_of_first)) {
      Cells cells;
      for (const Primitive* primitive : primitives) cells.add(*primitive);
      const std::set<int> apart = cells.overlapping();
      for (Primitive* primitive : primitives) primitive->own_light_map = apart.contains(primitive->material);
    }
    for (const Primitive* primitive : primitives) light_maps.insert(skin_mesh_key(*primitive));
  }
  check_skin_nodes(file, light_maps.size());
}

}  // namespace dermis::scene
