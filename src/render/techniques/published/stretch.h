// SPDX-License-Identifier: MIT
/// The stretch map of an unwrap, once: no mesh moves here.
/// Based on: [DLE07] GPU Gems 3, ch. 14.4.2
#pragma once

#include "frame/graph.h"
#include "render/techniques/published/object.h"

namespace dermis::techniques::papers {

class Stretch {
 public:
  struct Settings {
    Object object;  ///< any of the mesh
  } settings;
  struct In {
    frame::TextureId stretch;  ///< RGBA16F, T_max x T_max, persistent: see stretch.frag
  } in;
  struct Out {};
  Out declare(frame::Declare& d);
  void prepare(gpu::PipelineLibrary& library);
  void record(gpu::Cmd& cmd, const frame::Resources& resources, const FrameData& frame) const;

 private:
  const gpu::Pipeline* pipeline_ = nullptr;
};

}  // namespace dermis::techniques::papers
