// SPDX-License-Identifier: MIT
/// Lists the tiles that hold light, for convolutions over those alone; see shared/tiles_io.h.
#pragma once

#include <vector>

#include "passes/compute_pass.h"
#include "passes/light_pool.h"
#include "passes/tile_lists.h"

namespace dermis::passes {

/// Finds what each tile holds: lit texels, unlit ones, both.
class TileClasses : public ComputePass {
 public:
  struct Settings {
    std::vector<MapSquare> squares;
  } settings;
  struct In {
    frame::TextureId light;  ///< RGBA16F pool
    TileLists lists;         ///< their classes are filled here
  } in;
  struct Out {};
  Out declare(frame::Declare& d);
  void record(gpu::Cmd& cmd, const frame::Resources& resources, const FrameData& frame) const;
};

class Tiles : public ComputePass {
 public:
  enum class What : std::uint8_t {
    lit,     ///< tiles with lit texels are listed
    border,  ///< tiles with unlit texels that touch a tile with lit ones, or hold both
  };
  struct Settings {
    std::vector<MapSquare> squares;
    What what = What::lit;
    std::uint32_t first_slot = 0;  ///< of the counters: lit tiles, one per skin mesh of each instance
    std::uint32_t slots_per_instance = 0, slots_per_mesh = 0;
  } settings;
  struct In {
    TileLists lists;           ///< made from their classes
    frame::BufferId counters;  ///< uint[]
  } in;
  struct Out {};
  Out declare(frame::Declare& d);
  void record(gpu::Cmd& cmd, const frame::Resources& resources, const FrameData& frame) const;
};

/// Clears the tiles without light in the maps that convolutions will write and read.
class IdleTiles : public ComputePass {
 public:
  struct Settings {
    std::vector<MapSquare> squares;
  } settings;
  struct In {
    TileLists lists;
    struct Map {
      frame::TextureId light;  ///< RGBA16F pool
      /// The term that it holds. Heads do without maps of terms before MappedTerms::first_written.
      std::uint32_t term = ~0u;
    };
    std::vector<Map> maps;
  } in;
  struct Out {};
  Out declare(frame::Declare& d);
  void record(gpu::Cmd& cmd, const frame::Resources& resources, const FrameData& frame) const;
};

}  // namespace dermis::passes
