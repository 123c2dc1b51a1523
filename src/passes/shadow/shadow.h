// SPDX-License-Identifier: MIT
/// Depth as each light sees one head: a layer a light, six for a point light inside the scene. Reversed depth, 0 where nothing is.
#pragma once

#include "frame/plan.h"
#include "passes/frame_data.h"

namespace dermis::passes {

class Shadow {
 public:
  struct Settings {
    std::uint32_t instance = 0;
    std::uint32_t layers = 1;  ///< of one head
  };
  struct In {
    frame::TextureId shadow;  ///< D32; this head's layers begin at Instance::first_shadow_layer
  };
  struct Out {
    frame::TextureId shadow;
  };
  explicit Shadow(const Settings& settings) : settings_(settings) {}
  Out declare(frame::Declare& d, const In& in);
  void prepare(gpu::PipelineLibrary& library);
  void record(gpu::Cmd& cmd, const frame::Resources& resources, const frame::FrameData& frame) const;

 private:
  Settings settings_;
  In in_;
  const gpu::Pipeline* solid_ = nullptr;
  const gpu::Pipeline* cut_out_ = nullptr;
};

}  // namespace dermis::passes
