// SPDX-License-Identifier: MIT
/// Where the skin meshes of a batch of heads lie in the textures that they share: one square each, in rows.
/// Batches of heads take turns with the pool. If a single head has more skin meshes than the pool has
/// squares, its meshes take turns, too.
#pragma once

#include <vector>

#include "render/passes/light_map/light_pool.h"
#include "render/techniques/batches.h"

namespace dermis::techniques {

class MapPool {
 public:
  explicit MapPool(const FrameSettings& settings) : settings_(&settings) {}

  std::uint32_t meshes_per_batch() const;
  std::uint32_t mesh_batches() const;
  bool splits_heads() const { return mesh_batches() > 1; }  ///< the meshes of a head take turns
  /// Of the pool.
  std::uint32_t squares() const { return settings_->heads_per_batch * meshes_per_batch(); }

  std::uint32_t batches() const;  ///< turns of the pool in a frame
  passes::MapPlace place(std::uint32_t head, std::uint32_t mesh_in_model) const;
  std::vector<std::vector<passes::MapPlace>> places() const;  ///< [head][mesh in its model]
  /// Of these heads and those of their skin meshes that take turn `mesh_batch`: see squares_of().
  std::vector<passes::MapSquare> squares(const Batch& batch, std::uint32_t mesh_batch) const;
  /// A texture, RGBA16F, that holds all squares.
  gpu::TextureDesc texture() const;

 private:
  std::uint32_t meshes() const { return settings_->most_meshes(); }
  std::uint32_t columns() const;

  const FrameSettings* settings_;
};

}  // namespace dermis::techniques
