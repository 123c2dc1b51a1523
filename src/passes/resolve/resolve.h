// SPDX-License-Identifier: MIT
/// Averages the samples of a multisampled target.
#pragma once

#include "frame/graph.h"
#include "passes/frame_data.h"

namespace dermis::passes {

class Resolve {
 public:
  struct Settings {};
  struct In {
    frame::TextureId picture;  ///< more than one sample
  };
  struct Out {
    frame::TextureId picture;  ///< one sample
  };
  explicit Resolve(const Settings&) {}
  Out declare(frame::Declare& d, const In& in);
  void prepare(gpu::PipelineLibrary&) {}
  void record(gpu::Cmd& cmd, const frame::Resources& resources, const FrameData& frame) const;

 private:
  In in_;
  frame::TextureId target_;
};

}  // namespace dermis::passes
