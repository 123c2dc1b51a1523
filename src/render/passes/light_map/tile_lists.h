// SPDX-License-Identifier: MIT
// The tiles of light maps that a frame lights and blurs: the passes of tiles/ make the lists, and passes over
// texels dispatch by them. See render/shared/tiles_io.h.
#pragma once

#include <cstddef>
#include <cstdint>

#include "frame/graph.h"
#include "render/passes/light_map/light_pool.h"

namespace dermis::passes {

/// Each square of a pool has a list of lit tiles per material, and after those one of the tiles to blur.
struct TileLists {
  frame::BufferId marks;      ///< uint[]; of each tile, `room` per square
  frame::BufferId tiles;      ///< uint[]; x | y << 16 of each listed tile, `room` per list
  frame::BufferId counts;     ///< uint[]; of listed tiles, one per list
  frame::BufferId arguments;  ///< TileArgumentsIo[], one per list
  std::uint32_t room = 0;     ///< tiles of the largest square
  std::uint32_t lists = 0;    ///< per square

  /// Returns the list of the tiles that hold texels of a square's n-th material.
  std::uint32_t of_material(const UsedSquare& square, std::size_t material) const;
  /// Returns the list of a square's tiles to blur.
  std::uint32_t to_blur(const UsedSquare& square) const { return (square.index + 1) * lists - 1; }
};

/// Makes the lists of a pool. materials: of the skin mesh with most.
TileLists make_tile_lists(frame::FrameGraph& graph, std::uint32_t squares, std::uint32_t largest_side,
                          std::uint32_t materials);

}  // namespace dermis::passes
