// SPDX-License-Identifier: MIT
/// Counters of work done, for the statistics: how many texels of a map (or pixels of a picture) have at least
/// a given alpha. Runs for statistics.
#pragma once

#include "passes/compute_pass.h"
#include "passes/light_pool.h"

namespace dermis::passes {

class Count : public ComputePass {
 public:
  struct Settings {
    std::uint32_t slot = 0;
    float threshold = 0.5f;
    bool absolute = false;           ///< of the alpha's absolute value
    std::vector<MapSquare> squares;  ///< only their used areas are counted; none: the whole picture
  } settings;
  struct In {
    frame::TextureId picture;  ///< one sample
    frame::BufferId counters;  ///< uint[]; cleared by ClearCounters
  } in;
  struct Out {};
  Out declare(frame::Declare& d);
  void record(gpu::Cmd& cmd, const frame::Resources& resources, const FrameData& frame) const;
};

class ClearCounters {
 public:
  struct Settings {
  } settings;
  struct In {
    frame::BufferId counters;
  } in;
  struct Out {};
  Out declare(frame::Declare& d);
  void record(gpu::Cmd& cmd, const frame::Resources& resources, const FrameData& frame) const;
};

}  // namespace dermis::passes
