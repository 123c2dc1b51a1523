// SPDX-License-Identifier: MIT
/// Counters of work done, for the statistics: how many texels of a map (or pixels of a picture) have at least
/// a given alpha. Runs for statistics.
#pragma once

#include "passes/light_pool.h"

namespace dermis::passes {

class Count {
 public:
  struct Settings {
    std::uint32_t slot = 0;
    float threshold = 0.5f;
    bool absolute = false;           ///< of the alpha's absolute value
    std::vector<MapSquare> squares;  ///< only their used areas are counted; none: the whole picture
  };
  struct In {
    frame::TextureId picture;  ///< one sample
    frame::BufferId counters;  ///< uint[]; cleared by ClearCounters
  };
  struct Out {};
  explicit Count(const Settings& settings) : settings_(settings) {}
  Out declare(frame::Declare& d, const In& in);
  void prepare(gpu::PipelineLibrary& library);
  void record(gpu::Cmd& cmd, const frame::Resources& resources, const FrameData& frame) const;

 private:
  Settings settings_;
  In in_;
  const gpu::Pipeline* pipeline_ = nullptr;
  VkSampler sampler_ = VK_NULL_HANDLE;
};

class ClearCounters {
 public:
  struct Settings {};
  struct In {
    frame::BufferId counters;
  };
  struct Out {};
  explicit ClearCounters(const Settings&) {}
  Out declare(frame::Declare& d, const In& in);
  void prepare(gpu::PipelineLibrary&) {}
  void record(gpu::Cmd& cmd, const frame::Resources& resources, const FrameData& frame) const;

 private:
  In in_;
};

}  // namespace dermis::passes
