// SPDX-License-Identifier: MIT
#include "render/techniques/texture_space/map_pool.h"

#include <algorithm>
#include <bit>
#include <cmath>

namespace dermis::techniques {

std::uint32_t MapPool::meshes_per_batch() const {
  return settings_->meshes_per_batch == 0 ? meshes() : std::min(settings_->meshes_per_batch, meshes());
}

std::uint32_t MapPool::mesh_batches() const {
  return meshes() == 0 ? 0 : (meshes() + meshes_per_batch() - 1) / meshes_per_batch();
}

// Sides of pools for parts of a head are powers of two, whose coordinates do not round: the picture is the
// same for every budget.
std::uint32_t MapPool::columns() const {
  const auto least = static_cast<std::uint32_t>(std::ceil(std::sqrt(squares())));
  return splits_heads() ? std::bit_ceil(least) : least;
}

std::uint32_t MapPool::batches() const {
  const std::uint32_t heads = settings_->heads_per_batch;
  return (settings_->head_count() + heads - 1) / heads * mesh_batches();
}

passes::MapPlace MapPool::place(std::uint32_t head, std::uint32_t mesh_in_model) const {
  const std::uint32_t index =
      head % settings_->heads_per_batch * meshes_per_batch() + mesh_in_model % meshes_per_batch();
  const std::uint32_t side = settings_->square_side;
  return {.index = index,
          .origin = glm::uvec2(index % columns(), index / columns()) * side,
          .square_side = side,
          .batch = head / settings_->heads_per_batch * mesh_batches() + mesh_in_model / meshes_per_batch()};
}

std::vector<std::vector<passes::MapPlace>> MapPool::places() const {
  std::vector<std::vector<passes::MapPlace>> all(settings_->head_count());
  for (std::uint32_t head = 0; head < settings_->head_count(); ++head)
    for (std::uint32_t mesh = 0; mesh < settings_->model_of(head).meshes; ++mesh)
      all[head].push_back(place(head, mesh));
  return all;
}

std::vector<passes::MapSquare> MapPool::squares(const Batch& batch, std::uint32_t mesh_batch) const {
  const std::uint32_t first = mesh_batch * meshes_per_batch();
  return squares_of(*settings_, batch, first, first + meshes_per_batch());
}

gpu::TextureDesc MapPool::texture() const {
  const std::uint32_t rows = (squares() + columns() - 1) / columns();
  return {.width = columns() * settings_->square_side,
          .height = rows * settings_->square_side,
          .format = VK_FORMAT_R16G16B16A16_SFLOAT};
}

}  // namespace dermis::techniques
