// SPDX-License-Identifier: MIT
#include "render/passes/light_map/tile_lists.h"

#include <algorithm>

#include "render/shared/tiles_io.h"

namespace dermis::passes {

std::uint32_t TileLists::of_material(const UsedSquare& square, std::size_t material) const {
  return square.index * lists + static_cast<std::uint32_t>(std::min<std::size_t>(material, lists - 2));
}

TileLists make_tile_lists(frame::FrameGraph& graph, std::uint32_t squares, std::uint32_t largest_side,
                          std::uint32_t materials) {
  const glm::uvec2 across = io::tiles_across(largest_side);
  const std::uint32_t room = across.x * across.y;
  const std::uint32_t per_square = std::clamp<std::uint32_t>(materials, 1, MOST_TILE_LISTS) + 1;
  const std::uint64_t lists = std::uint64_t{squares} * per_square;
  return {
      .marks = graph.buffer("tile marks", {.bytes = std::uint64_t{squares} * room * sizeof(std::uint32_t)}),
      .tiles = graph.buffer("tiles", {.bytes = lists * room * sizeof(std::uint32_t)}),
      .counts = graph.buffer("tile counts", {.bytes = lists * sizeof(std::uint32_t)}),
      .arguments = graph.buffer("tile arguments", {.bytes = lists * sizeof(io::TileArgumentsIo)}),
      .room = room,
      .lists = per_square};
}

}  // namespace dermis::passes
