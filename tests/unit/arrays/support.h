// SPDX-License-Identifier: MIT
// What the tests of scenes from arrays share: arrays of a scene, a glTF file of arrays, scenes compared to
// the bit.
#pragma once

#include <array>
#include <cstdint>
#include <list>
#include <vector>

#include "dermis/asset_arrays.h"
#include "head/scene/asset_data.h"
#include "unit/gltf/support.h"

namespace dermis::scene::test {

using Float2s = std::vector<std::array<float, 2>>;
using Float3s = std::vector<std::array<float, 3>>;
using Float4s = std::vector<std::array<float, 4>>;

/// What a mesh of AssetArrays borrows.
struct OwnedMesh {
  Float3s positions_m, normals;
  Float4s tangents, colours;
  Float2s uv0, uv1;
  std::vector<std::uint32_t> indices;

  /// Points the spans of `mesh` at these.
  void lend(AssetMesh& mesh) const;
};

/// The arrays of a scene without placements, and what they borrow: attributes that it has, texture
/// coordinates 1 and colours only where they differ from their defaults.
class ArraysOf {
 public:
  enum class Tangents : std::uint8_t { none, all };
  ArraysOf(const AssetData& scene, Tangents tangents);
  ArraysOf(const ArraysOf&) = delete;
  ArraysOf& operator=(const ArraysOf&) = delete;

  AssetArrays given;

 private:
  std::list<OwnedMesh> owned_;
};

/// Returns a glTF file with the same content, a node for each mesh, its pictures as PNG. Transforms of maps
/// only scale and move.
Builder gltf_of(const AssetArrays& given);

/// Fails where two scenes differ. Components of normals and tangents may differ by `directions`, all else by
/// no bit. Names of scenes are not compared.
void expect_same(const AssetData& made, const AssetData& expected, float directions = 0);

}  // namespace dermis::scene::test
