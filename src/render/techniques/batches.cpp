// SPDX-License-Identifier: MIT
#include "render/techniques/batches.h"

#include <fmt/format.h>

#include <algorithm>
#include <iterator>

namespace dermis::techniques {

using passes::MapSquare;

std::vector<Batch> batches_of(const FrameSettings& settings) {
  std::vector<Batch> batches;
  for (std::uint32_t first = 0; first < settings.head_count(); first += settings.heads_per_batch)
    batches.push_back({.number = static_cast<std::uint32_t>(batches.size()),
                       .first_head = first,
                       .heads = std::min(settings.heads_per_batch, settings.head_count() - first)});
  return batches;
}

std::vector<MapSquare> squares_of(const FrameSettings& settings, const Batch& batch, std::uint32_t first_mesh,
                                  std::uint32_t end_mesh) {
  std::vector<MapSquare> all;
  for (std::uint32_t head = batch.first_head; head < batch.first_head + batch.heads; ++head) {
    const Model& model = settings.model_of(head);
    for (std::uint32_t mesh = first_mesh; mesh < std::min(end_mesh, model.meshes); ++mesh)
      all.push_back({.head = head, .mesh = model.first_mesh + mesh});
  }

  std::ranges::stable_sort(all, {}, &MapSquare::mesh);
  return all;
}

std::vector<MapSquare> of_mesh(const std::vector<MapSquare>& all, std::uint32_t mesh) {
  std::vector<MapSquare> squares;
  std::ranges::copy_if(all, std::back_inserter(squares), [&](const MapSquare& s) { return s.mesh == mesh; });
  return squares;
}

std::vector<std::uint32_t> meshes_of(const std::vector<MapSquare>& all) {
  std::vector<std::uint32_t> meshes;
  for (const MapSquare& square : all)
    if (meshes.empty() || meshes.back() != square.mesh) meshes.push_back(square.mesh);
  return meshes;
}

std::string label(std::string_view what, const FrameSettings& settings, const Batch& batch) {
  const bool several = settings.head_count() > settings.heads_per_batch;
  return several ? fmt::format("{} batch {}", what, batch.number) : std::string(what);
}

}  // namespace dermis::techniques
