// SPDX-License-Identifier: MIT
// Lists of the tiles of light maps, shared by the pass that makes them and the convolutions that use them;
// see shared/tiles_io.h.
#pragma once

#include <cstdint>
#include <string>

#include "frame/graph.h"

namespace dermis::passes {

/// Returns the largest number of tiles of a square of this side.
std::uint32_t tile_room(std::uint32_t side);

/// Inputs of convolutions over tiles: see Blur::In.
struct TileLists {
  frame::BufferId classes;    ///< uint[]; what each tile holds, tile_room() per square
  frame::BufferId tiles;      ///< uint[]; tile_room() entries per square
  frame::BufferId counts;     ///< TileCountsIo[], one per square
  frame::BufferId arguments;  ///< TileArgumentsIo[], one per square
  std::uint32_t room = 0;     ///< entries per square
  bool valid() const { return room > 0; }
};
TileLists make_tile_lists(frame::FrameGraph& graph, const std::string& name, std::uint32_t squares,
                          std::uint32_t largest_side);

}  // namespace dermis::passes
