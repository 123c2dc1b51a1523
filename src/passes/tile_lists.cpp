// SPDX-License-Identifier: MIT
#include "passes/tile_lists.h"

#include "shared/tiles_io.h"

namespace dermis::passes {

std::uint32_t tile_room(std::uint32_t side) {
  return ((side + TILE_WIDTH - 1) / TILE_WIDTH) * ((side + TILE_HEIGHT - 1) / TILE_HEIGHT);
}

TileLists make_tile_lists(frame::FrameGraph& graph, const std::string& name, std::uint32_t squares,
                          std::uint32_t largest_side) {
  const std::uint32_t room = tile_room(largest_side);
  const auto buffer = [&](const char* what, std::size_t bytes) {
    return graph.buffer(name + " " + what, {.bytes = std::uint64_t{squares} * bytes});
  };
  return {.classes = buffer("tile classes", room * sizeof(std::uint32_t)),
          .tiles = buffer("tiles", room * sizeof(std::uint32_t)),
          .counts = buffer("tile counts", sizeof(io::TileCountsIo)),
          .arguments = buffer("tile arguments", sizeof(io::TileArgumentsIo)),
          .room = room};
}

}  // namespace dermis::passes
