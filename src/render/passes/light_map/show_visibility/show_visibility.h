// SPDX-License-Identifier: MIT
/// Draws what the optimisations leave out of one head's light map.
/// Based on: [JG08] figure 3
#pragma once

#include "render/passes/light_map/light_pool.h"

namespace dermis::passes {

class ShowVisibility {
 public:
  struct Settings {
    MapSquare square;
    bool cull = true, clip = true;
    bool cut_out = false;  ///< some of its skin is cut out, and not shown
  } settings;
  struct In {
    /// RGBA16F, T_max x T_max, persistent: the used square from its corner, alpha 0 where no skin is
    frame::TextureId picture;
  } in;
  struct Out {};
  Out declare(frame::Declare& d);
  void prepare(gpu::PipelineLibrary& library);
  void record(gpu::Cmd& cmd, const frame::Resources& resources, const FrameData& frame) const;

 private:
  const gpu::Pipeline* pipelines_[2] = {};  // [cut out]
};

}  // namespace dermis::passes
