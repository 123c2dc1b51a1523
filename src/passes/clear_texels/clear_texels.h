// SPDX-License-Identifier: MIT
/// Fills what a frame uses of light maps with zeros, in compute: a device need not begin to render for that;
/// and buffers.
#pragma once

#include <vector>

#include "passes/compute_pass.h"
#include "passes/light_pool.h"

namespace dermis::passes {

class ClearTexels : public ComputePass {
 public:
  struct Settings {
    std::vector<MapSquare> squares;
  } settings;
  struct In {
    std::vector<frame::TextureId> maps;  ///< RGBA16F pools
    std::vector<frame::BufferId> buffers;
  } in;
  struct Out {};
  Out declare(frame::Declare& d);
  void record(gpu::Cmd& cmd, const frame::Resources& resources, const FrameData& frame) const;
};

}  // namespace dermis::passes
