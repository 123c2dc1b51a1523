// SPDX-License-Identifier: MIT
/// Fills textures with zeros, in every frame: those into which passes write at some pixels alone.
#pragma once

#include <vector>

#include "frame/graph.h"
#include "gpu/cmd.h"
#include "passes/frame_data.h"

namespace dermis::passes {

class ClearTextures {
 public:
  struct Settings {
  } settings;
  struct In {
    std::vector<frame::TextureId> textures;
  } in;
  struct Out {};
  Out declare(frame::Declare& d);
  void record(gpu::Cmd& cmd, const frame::Resources& resources, const FrameData& frame) const;
};

}  // namespace dermis::passes
