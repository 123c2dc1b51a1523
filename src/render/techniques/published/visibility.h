// SPDX-License-Identifier: MIT
/// Draws what is left out of an object's light map.
/// Based on: [JG08] figure 3
#pragma once

#include "frame/graph.h"
#include "render/techniques/published/object.h"

namespace dermis::techniques::papers {

class Visibility {
 public:
  struct Settings {
    Object object;
    bool cull = true, clip = true;
    bool cut_out = false;  ///< some of its skin is cut out, and not shown
  } settings;
  struct In {
    frame::TextureId picture;  ///< RGBA16F, T_max x T_max, persistent
  } in;
  struct Out {};
  Out declare(frame::Declare& d);
  void prepare(gpu::PipelineLibrary& library);
  void record(gpu::Cmd& cmd, const frame::Resources& resources, const FrameData& frame) const;

 private:
  const gpu::Pipeline* pipelines_[2] = {};  // [cut out]
};

}  // namespace dermis::techniques::papers
