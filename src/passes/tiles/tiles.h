// SPDX-License-Identifier: MIT
/// Lists of the tiles that hold light, for convolutions that run on those alone; see shared/tiles_io.h.
#pragma once

#include <vector>

#include "passes/light_pool.h"
#include "passes/tile_lists.h"

namespace dermis::passes {

/// Forgets the lists of the frame before.
class ClearTiles {
 public:
  struct Settings {};
  struct In {
    TileLists lists;
  };
  struct Out {};
  explicit ClearTiles(const Settings&) {}
  Out declare(frame::Declare& d, const In& in);
  void prepare(gpu::PipelineLibrary&) {}
  void record(gpu::Cmd& cmd, const frame::Resources& resources, const FrameData& frame) const;

 private:
  In in_;
};

/// What each tile holds: lit texels, unlit ones, both.
class TileClasses {
 public:
  struct Settings {
    std::vector<MapSquare> squares;
  };
  struct In {
    frame::TextureId light;  ///< RGBA16F pool
    TileLists lists;         ///< their classes are filled here
  };
  struct Out {};
  explicit TileClasses(const Settings& settings) : settings_(settings) {}
  Out declare(frame::Declare& d, const In& in);
  void prepare(gpu::PipelineLibrary& library);
  void record(gpu::Cmd& cmd, const frame::Resources& resources, const FrameData& frame) const;

 private:
  Settings settings_;
  In in_;
  const gpu::Pipeline* pipeline_ = nullptr;
  VkSampler sampler_ = VK_NULL_HANDLE;
};

class Tiles {
 public:
  enum class What : std::uint8_t {
    lit,     ///< tiles with lit texels are listed
    border,  ///< tiles with unlit texels that touch a tile with lit ones, or hold both
  };
  struct Settings {
    std::vector<MapSquare> squares;
    What what = What::lit;
    std::uint32_t first_slot = 0;  ///< of the counters: lit tiles, one per mesh
    std::uint32_t slot_stride = 1;
  };
  struct In {
    TileLists lists;           ///< made from their classes
    frame::BufferId counters;  ///< uint[]
  };
  struct Out {};
  explicit Tiles(const Settings& settings) : settings_(settings) {}
  Out declare(frame::Declare& d, const In& in);
  void prepare(gpu::PipelineLibrary& library);
  void record(gpu::Cmd& cmd, const frame::Resources& resources, const FrameData& frame) const;

 private:
  Settings settings_;
  In in_;
  const gpu::Pipeline* pipeline_ = nullptr;
};

/// Clears the tiles without light in the maps that convolutions will write and read.
class IdleTiles {
 public:
  struct Settings {
    std::vector<MapSquare> squares;
  };
  struct In {
    TileLists lists;
    std::vector<frame::TextureId> maps;  ///< RGBA16F pools
  };
  struct Out {};
  explicit IdleTiles(const Settings& settings) : settings_(settings) {}
  Out declare(frame::Declare& d, const In& in);
  void prepare(gpu::PipelineLibrary& library);
  void record(gpu::Cmd& cmd, const frame::Resources& resources, const FrameData& frame) const;

 private:
  Settings settings_;
  In in_;
  const gpu::Pipeline* pipeline_ = nullptr;
};

}  // namespace dermis::passes
