// SPDX-License-Identifier: MIT
// Lists of the tiles of light maps, as the pass that makes them and the convolutions that use them share
// them; see shared/tiles_io.h.
#pragma once

#include <cstdint>
#include <string>

#include "frame/graph.h"

namespace dermis::passes {

/// Tiles that a square of this side has at most.
std::uint32_t tile_room(std::uint32_t side);

/// What convolutions over tiles need: see Blur::In.
struct TileLists {
  frame::BufferId classes;    ///< uint[]; what each tile holds, room for tile_room() a square
  frame::BufferId tiles;      ///< uint[]; room for tile_room() entries a square
  frame::BufferId counts;     ///< TileCountsIo[], one a square
  frame::BufferId arguments;  ///< TileArgumentsIo[], one a square
  std::uint32_t room = 0;     ///< entries a square
};
TileLists make_tile_lists(frame::FrameGraph& graph, const std::string& name, std::uint32_t squares,
                          std::uint32_t largest_side);

}  // namespace dermis::passes
