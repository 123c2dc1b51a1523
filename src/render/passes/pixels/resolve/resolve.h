// SPDX-License-Identifier: MIT
/// Averages the samples of a multisampled target.
#pragma once

#include "frame/graph.h"
#include "render/passes/frame_data.h"

namespace dermis::passes {

class Resolve {
 public:
  struct Settings {
  } settings;
  struct In {
    frame::TextureId picture;  ///< more than one sample
  } in;
  struct Out {
    frame::TextureId picture;  ///< one sample
  };
  Out declare(frame::Declare& d);
  void record(gpu::Cmd& cmd, const frame::Resources& resources, const FrameData& frame) const;

 private:
  frame::TextureId target_;
};

}  // namespace dermis::passes
