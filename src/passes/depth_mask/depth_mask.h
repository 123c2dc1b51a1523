// SPDX-License-Identifier: MIT
/// Marks texels that hold light in a depth image, so that the depth test keeps convolutions off the others.
/// Based on: [JG08] Jimenez, Gutierrez: Faster Rendering of Human Skin, CEIG 2008, sec. 3
#pragma once

#include "passes/light_pool.h"

namespace dermis::passes {

class DepthMask {
 public:
  struct Settings {
    std::vector<MapSquare> squares;
  } settings;
  struct In {
    frame::TextureId light;  ///< RGBA16F pool
    frame::TextureId mask;   ///< D32 pool: 1 where the light's alpha is not 0, else 0
  } in;
  struct Out {};
  Out declare(frame::Declare& d);
  void prepare(gpu::PipelineLibrary& library);
  void record(gpu::Cmd& cmd, const frame::Resources& resources, const FrameData& frame) const;

 private:
  const gpu::Pipeline* pipeline_ = nullptr;
};

}  // namespace dermis::passes
