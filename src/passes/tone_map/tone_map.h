// SPDX-License-Identifier: MIT
/// The tone map: from linear radiance to eight bits for a display.
#pragma once

#include "dermis/settings.h"
#include "frame/graph.h"
#include "passes/frame_data.h"

namespace dermis::passes {

class ToneMap {
 public:
  struct Settings {
    dermis::ToneMap tone_map = dermis::ToneMap::natural;
  };
  struct In {
    frame::TextureId picture;  ///< RGBA16F, one sample
  };
  struct Out {
    frame::TextureId display;  ///< RGBA8, copied from afterwards
  };
  explicit ToneMap(const Settings& settings) : settings_(settings) {}
  Out declare(frame::Declare& d, const In& in);
  void prepare(gpu::PipelineLibrary& library);
  void record(gpu::Cmd& cmd, const frame::Resources& resources, const FrameData& frame) const;

 private:
  Settings settings_;
  In in_;
  frame::TextureId display_;
  const gpu::Pipeline* pipeline_ = nullptr;
  VkSampler sampler_ = VK_NULL_HANDLE;
};

}  // namespace dermis::passes
