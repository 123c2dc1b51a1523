// SPDX-License-Identifier: MIT
/// Finds the tiles of light maps that a frame lights and blurs: SeenTiles, then Tiles.
/// Based on: [JG08] Jimenez, Gutierrez: Faster Rendering of Human Skin, CEIG 2008, sec. 3 and 5. Departures:
/// README.md
#pragma once

#include <vector>

#include "render/passes/compute_pass.h"
#include "render/passes/light_map/light_pool.h"
#include "render/passes/light_map/tile_lists.h"

namespace dermis::passes {

/// Marks the tiles of triangles that a pixel may show.
class SeenTiles : public ComputePass {
 public:
  struct Settings {
    std::vector<MapSquare> squares;
    bool cull = true;   ///< leaves out what faces away, see render/shaders/cull.glsl
    bool clip = false;  ///< leaves out what lies outside the picture and its margin
    /// By skin mesh of the plan, texture coordinates of the light map: how far from a point of the skin light
    /// is read that leaves there, at most.
    std::vector<float> exit_offsets;
  } settings;
  struct In {
    TileLists lists;  ///< marks and counts are 0
  } in;
  struct Out {};
  Out declare(frame::Declare& d);
  void record(gpu::Cmd& cmd, const frame::Resources& resources, const FrameData& frame) const;
};

/// Makes the lists from the marks, with the tiles that seen ones take beyond seams, and fills the maps with
/// zeros: taps read tiles that nothing lights.
class Tiles : public ComputePass {
 public:
  struct Settings {
    std::vector<MapSquare> squares;
    std::uint32_t first_slot = 0;  ///< of the counters: tiles to blur, one per skin mesh of each head
    std::uint32_t slots_per_head = 0, slots_per_mesh = 0;
  } settings;
  struct In {
    TileLists lists;
    frame::BufferId counters;                 ///< uint[]
    std::vector<frame::TextureId> maps = {};  ///< RGBA16F pools to fill
  } in;
  struct Out {};
  Out declare(frame::Declare& d);
  void prepare(gpu::PipelineLibrary& library);
  void record(gpu::Cmd& cmd, const frame::Resources& resources, const FrameData& frame) const;

 private:
  void clear(gpu::Cmd& cmd, const frame::Resources& resources, const std::vector<UsedSquare>& squares) const;
  const gpu::Pipeline* clear_ = nullptr;
};

}  // namespace dermis::passes
