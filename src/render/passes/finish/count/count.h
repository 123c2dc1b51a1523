// SPDX-License-Identifier: MIT
/// Counts work for the statistics: texels of a map (or pixels of a picture) with at least a given alpha. Not
/// part of a timed frame.
#pragma once

#include "render/passes/compute_pass.h"
#include "render/passes/light_map/light_pool.h"

namespace dermis::passes {

class Count : public ComputePass {
 public:
  struct Settings {
    std::uint32_t slot = 0;
    std::uint32_t slots_per_head = 0;  ///< squares of head i count at slot + i * slots_per_head
    float threshold = 0.5f;
    std::vector<MapSquare> squares;  ///< counts only their used areas; empty: the whole picture
  } settings;
  struct In {
    frame::TextureId picture;  ///< one sample
    frame::BufferId counters;  ///< uint[]; cleared before
  } in;
  struct Out {};
  Out declare(frame::Declare& d);
  void record(gpu::Cmd& cmd, const frame::Resources& resources, const FrameData& frame) const;
};

}  // namespace dermis::passes
